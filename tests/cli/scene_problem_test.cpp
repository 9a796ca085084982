// SPDX-License-Identifier: BSD-3-Clause
// Scenes as problems of every command: truth, errors in m, runs that blow up.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <regex>
#include <sstream>

#include "odeum/cases/scene_case.hpp"
#include "odeum/core/counted_solver.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::scene_problem_test {
namespace {

using scene::Scene;
using scene::SceneProblem;

Scene spring_scene(double until) {
  Scene scene;
  scene.duration = until;
  scene.particles = {{.position = {0, 0, 0}, .fixed = true}, {.position = {1.5, 0, 0}, .mass = 2}};
  scene.springs = {{.a = 0, .b = 1, .stiffness = 8, .rest_length = 1}};
  return scene;
}

TEST(SceneTruth, OfASpringIsItsCosine) {
  const auto problem = std::make_shared<const SceneProblem>(spring_scene(3));
  const auto known = cases::scene_truth(problem, {1, 2, 3}, "SceneTruth spring", "spring");
  ASSERT_EQ(known.stops.size(), 3U);
  EXPECT_LT(known.truth.floor, 1e-14);
  std::vector<double> y(12);
  for (const double t : {1.0, 2.0, 3.0}) {
    ASSERT_TRUE(known.truth.at(t, y.data()));
    // x = 1 + cos(2 t) / 2; the floor, and the rounding of the cosine.
    EXPECT_NEAR(y[3], 1 + std::cos(2 * t) / 2, known.truth.floor + 2e-16);
    EXPECT_NEAR(y[9], -std::sin(2 * t), known.truth.floor + 2e-16);
  }
}

// Equal springs in line pull to both sides, so that what rounding does to each cancels where all
// coordinates move in one proportion: steps shrank to nothing within the first thousandth of it.
TEST(SceneTruth, GoesOnWhereForcesOfSpringsCancel) {
  Scene scene;
  scene.duration = 1;
  scene.gravity = {0, 0, -9.8};
  for (int i = 0; i < 8; ++i)
    scene.particles.push_back({.position = {0.2 * i, 0, 0}, .mass = 0.1, .fixed = i == 0});
  for (std::size_t i = 0; i + 1 < 8; ++i)
    scene.springs.push_back({.a = i, .b = i + 1, .stiffness = 300, .rest_length = 0.2});
  const auto problem = std::make_shared<const SceneProblem>(scene);
  const auto known = cases::scene_truth(problem, {0.5, 1}, "SceneTruth line", "line");
  EXPECT_EQ(known.known_until, 1) << known.words;
  EXPECT_LT(known.truth.floor, 1e-12);
}

TEST(SceneCommands, ConvergeTakesAScene) {
  const TemporaryFolder folder;
  const Result result = shell("odeum converge magnetic_helix --quick --solver odeum/rk4 --out " +
                              folder.path().string());
  ASSERT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("magnetic_helix  odeum/rk4  fixed"), std::string::npos)
      << result.output;
  EXPECT_NE(result.output.find("confirmed"), std::string::npos) << result.output;
}

TEST(SceneCommands, AdviseTakesAScene) {
  const Result result = shell("odeum advise spinning_pair --error 1e-3 --solver odeum/rk4");
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_TRUE(result.output.starts_with("odeum/rk4")) << result.output;
  EXPECT_NE(result.output.find("odeum run spinning_pair"), std::string::npos) << result.output;
}

TEST(SceneCommands, AStudyNamesWhatASceneWithEmittersLacks) {
  const TemporaryFolder folder;
  const std::string file = folder.path().string() + "/rain.yaml";
  std::ofstream(file)
      << "duration: 1\nparticles: [{pos: [0, 0, 0], mass: 1, radius: 0.1}]\n"
         "emitters: [{position: [0, 0, 1], velocity: [0, 0, -1], rate: 10, mass: 1}]\n"
         "contacts: [{particles: {stiffness: 100}}]\n";
  const Result result = shell("odeum converge " + file + " --solver odeum/rk4 --out /dev/null/no");
  EXPECT_EQ(result.code, 2);
  EXPECT_NE(result.output.find("no contact between particles"), std::string::npos) << result.output;
}

// The reader of a problem computes its truth, which took a minute before the name was looked at.
TEST(SceneCommands, AnUnknownSolverIsRefusedBeforeTheProblemIsRead) {
  for (const char* command : {"converge", "report --out /dev/null/no"}) {
    const Result result = shell(std::string("odeum ") + command + " none.yaml --solver rk5");
    EXPECT_EQ(result.code, 2);
    EXPECT_NE(result.output.find("no solver matches"), std::string::npos) << result.output;
  }
}

// Every particle in closed form, with births at the ends of steps where the step is fixed.
TEST(SceneCommands, EmittedParticlesHaveATruth) {
  const Result exact = shell("odeum run fountain --solver closed_form --tol 1e-9 --until 2");
  EXPECT_EQ(exact.code, 0) << exact.output;
  EXPECT_NE(exact.output.find("closed form of free particles"), std::string::npos) << exact.output;
  const Result smoke = shell("odeum run smoke --until 0.5 --solver dormand_prince54 --tol 1e-8");
  EXPECT_NE(smoke.output.find("each emitted particle by itself"), std::string::npos)
      << smoke.output;
  const std::regex small(R"(error      odeum/(\w+): ([0-9.]+(?:e-\d+)?) m at most)");
  for (const Result* result : {&exact, &smoke}) {
    std::smatch found;
    ASSERT_TRUE(std::regex_search(result->output, found, small)) << result->output;
    // The tolerance of the second, and what a few steps add up.
    EXPECT_LT(std::stod(found[2]), result == &exact ? 1e-12 : 1e-6) << result->output;
  }
}

// It went from 7 J to 4,092,743 J with "status ok" and code 0.
TEST(SceneCommands, ARunThatBlowsUpIsNotOk) {
  const Result result =
      shell("odeum run flag --solver odeum/ros2 --step 0.016666667 --until 1 --no-truth");
  EXPECT_EQ(result.code, 3) << result.output;
  EXPECT_NE(result.output.find("it has blown up: the energy is"), std::string::npos)
      << result.output;
}

// Steps at which explicit methods are not stable, on cloths, chains, bodies, contacts and emitted
// particles.
TEST(SceneCommands, NoUnstableRunEndsOk) {
  const char* const runs[] = {
      "flag --solver rk4 --step 0.005 --until 1",
      "flag --solver explicit_euler --step 0.002 --until 1",
      "flag --solver heun --step 0.005 --until 1",
      "flag --solver velocity_verlet --step 0.004 --until 1",
      "flag --solver bullet/soft_body_force --step 0.004 --until 1",
      "hanging_cloth --solver midpoint --step 0.01 --until 1",
      "hanging_cloth --solver velocity_verlet --step 0.02 --until 1",
      "hanging_cloth --solver explicit_euler --step 0.005 --until 1",
      "notebook_cloth --solver rk4 --step 0.2 --until 4",
      "notebook_cloth --solver explicit_euler --step 0.05 --until 4",
      "notebook_cloth_two_way --solver symplectic_euler --step 0.2 --until 4",
      "notebook_cloth_two_way --solver explicit_euler --step 0.05 --until 4",
      "tension_only_cloth --solver rk4 --step 0.007 --until 1",
      "tension_only_cloth --solver heun --step 0.01 --until 1",
      "sheet_coarse --solver midpoint --step 0.05 --until 2",
      "sheet_coarse --solver velocity_verlet --step 0.05 --until 2",
      "sheet_fine --solver rk4 --step 0.02 --until 1",
      "sheet_fine_heavy --solver rk4 --step 0.05 --until 2",
      "chain --solver velocity_verlet --step 0.02 --until 2",
      "chain --solver explicit_euler --step 0.01 --until 2",
      "stiff_rope --solver rk4 --step 0.01 --until 1",
      "stiff_rope --solver symplectic_euler --step 0.01 --until 1",
      "spring_explicit_euler --solver explicit_euler --step 0.5 --until 20",
      "spring_midpoint --solver midpoint --step 1 --until 20",
      "spring_symplectic_euler --solver symplectic_euler --step 1.25 --until 20",
      "spinning_pair --solver explicit_euler --step 0.1 --until 20",
      "spinning_pair --solver rk4 --step 0.5 --until 20",
      "spherical_pendulum --solver rk4 --step 0.05 --until 2",
      "spherical_pendulum --solver heun --step 0.02 --until 2",
      "magnetic_helix --solver explicit_euler --step 0.5 --until 12",
      "magnetic_helix --solver heun --step 3 --until 12",
      "raindrop --solver explicit_euler --step 2.5 --until 25",
      "jelly_cube --solver rk4 --step 0.02 --until 1",
      "jelly_cube --solver symplectic_euler --step 0.02 --until 1",
      "box_of_edges --solver rk4 --step 0.05 --until 1",
      "box_with_diagonals --solver heun --step 0.02 --until 1",
      "net --solver velocity_verlet --step 0.0053 --until 1",
      "bowl_of_balls --solver rk4 --step 0.05 --until 2",
      "bowl_of_balls --solver symplectic_euler --step 0.0069 --until 1",
      "stack_of_three --solver rk4 --step 0.03 --until 1",
      "stack_of_three --solver explicit_euler --step 0.01 --until 1",
      "cloth_on_sphere --solver velocity_verlet --step 0.02 --until 1",
      "cloth_on_sphere --solver rk4 --step 0.01 --until 1",
      "sparks --solver rk4 --step 0.25 --until 3",
      "sparks --solver explicit_euler --step 0.05 --until 3",
  };
  std::string script;
  for (const char* const run : runs)
    script += fmt::format("odeum run {0} --no-truth > /dev/null 2>&1; echo \"$? {0}\"\n", run);
  const Result result = shell(script + "true");
  std::istringstream lines(result.output);
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line); ++count)
    EXPECT_TRUE(line.starts_with("3 ")) << line;
  EXPECT_EQ(count, std::size(runs)) << result.output;
}

TEST(SceneCommands, ASolverThatDoesNotFitIsALineBesideOthers) {
  for (const char* const run : {"raindrop --solver rk4 --solver leapfrog --step 0.1",
                                "lotka_volterra --solver rk4 --solver leapfrog --step 0.1"}) {
    const Result result = shell(std::string("odeum run ") + run);
    EXPECT_EQ(result.code, 0) << result.output;
    EXPECT_NE(result.output.find("unfit      odeum/leapfrog: needs a second-order problem"),
              std::string::npos)
        << result.output;
  }
  const Result mode = shell("odeum run lotka_volterra --solver rk4 --solver bdf2 --tol 1e-3");
  EXPECT_EQ(mode.code, 0) << mode.output;
  EXPECT_NE(mode.output.find("odeum/bdf2: runs at a fixed step only"), std::string::npos)
      << mode.output;
}

TEST(SceneCommands, SolversThatFitAreListed) {
  const Result scene = shell("odeum list solvers raindrop --format csv");
  EXPECT_EQ(scene.code, 0) << scene.output;
  EXPECT_NE(scene.output.find("odeum/rk4,yes,"), std::string::npos) << scene.output;
  EXPECT_NE(scene.output.find("odeum/leapfrog,\"no: needs a second-order"), std::string::npos)
      << scene.output;
  EXPECT_EQ(shell("odeum list cases raindrop").code, 2);
}

TEST(SceneCommands, ATextRunsBeforeItsTruthIsComputed) {
  const TemporaryFolder folder;
  const std::string file = folder.path().string() + "/decay.yaml";
  std::ofstream(file) << "states: {x: 1}\nequations: {x: -x*(1 + 0.1*x)}\ntime: {end: 2}\n";
  const Result result = shell("odeum run " + file + " --solver rk4 --step 1/8");
  EXPECT_EQ(result.code, 0) << result.output;
  const std::size_t first = result.output.find("first      odeum/rk4: ok at t = 2");
  ASSERT_NE(first, std::string::npos) << result.output;
  EXPECT_LT(first, result.output.find("truth      computed")) << result.output;
  EXPECT_NE(result.output.find("; state 0.1"), std::string::npos) << result.output;
  // Also to a tolerance whose scale the truth proposes, and as rows.
  for (const std::string& words :
       {file + " --solver rk4 --tol 1e-3", file + " --solver rk4 --step 1/8 --format json"}) {
    const std::string output = shell("odeum run " + words).output;
    EXPECT_NE(output.find("first      odeum/rk4: ok at t = "), std::string::npos) << output;
  }
}

TEST(SceneCommands, AStepMayBeAFraction) {
  const Result result = shell("odeum run spinning_pair --solver rk4 --step 1/50 --until 1");
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("step       0.02, 50 steps"), std::string::npos) << result.output;
}

TEST(Tolerances, OfComponentsAreGivenByName) {
  const std::string run = "odeum run robertson_40 --solver rodas4 --rtol 1e-6 --atol ";
  const Result named = shell(run + "1e-8,y1=1e-14"), listed = shell(run + "1e-8,1e-14,1e-8");
  EXPECT_EQ(named.code, 0) << named.output;
  EXPECT_EQ(named.output, listed.output);
}

// Their energy stays below what gravity and springs give them, or only rounds it.
TEST(SceneCommands, RunsThatAreStableDoNotBlowUp) {
  for (const char* const run :
       {"spring_symplectic_euler --solver symplectic_euler --step 0.4 --until 20",
        "raindrop --solver explicit_euler --step 0.5 --until 5", "fountain --until 2",
        "sparks --until 2", "smoke --until 4", "stack_of_three --until 1",
        "fountain --solver explicit_euler --step 0.1 --until 3"}) {
    const Result result = shell(std::string("odeum run ") + run + " --no-truth");
    EXPECT_EQ(result.code, 0) << run << result.output;
  }
}

// Newton's method takes a dozen Jacobians by differences at the longest steps that it manages: what
// ends the search is that it fails, not its evaluations.
TEST(SceneCommands, TheLimitsOfImplicitMethodsAreNotThoseOfABudget) {
  const TemporaryFolder folder;
  const Result result =
      shell("odeum limits spinning_pair --solver radau_iia9 --solver gauss6 --out " +
            folder.path().string());
  EXPECT_EQ(result.code, 0) << result.output;
  std::ifstream file(folder.path() / "largest_steps.csv");
  const std::string rows(std::istreambuf_iterator<char>(file), {});
  EXPECT_NE(rows.find("gauss6,ok,"), std::string::npos) << rows;
  EXPECT_EQ(rows.find("evaluations of the right-hand side"), std::string::npos) << rows;
}

// A step's factors are part of what a run may cost.
TEST(SceneCommands, FactorsCountAgainstABudget) {
  const SceneProblem problem(spring_scene(3));
  const auto solver = problem.shifted_solver();
  const std::vector<double>& start = problem.start();
  ASSERT_TRUE(solver->factorise(0, start.data(), 1e-3));
  const std::uint64_t once = solver->products();
  EXPECT_GT(once, 0U);
  ASSERT_TRUE(solver->factorise(0, start.data(), 2e-3));
  EXPECT_EQ(solver->products(), 2 * once);

  Guard guard(problem.size(), {.evaluations = 3 * once});
  const auto counting = counted(problem.shifted_solver(), guard);
  for (int k = 0; k < 3; ++k) ASSERT_TRUE(counting->factorise(0, start.data(), 1e-3));
  EXPECT_FALSE(guard.admit());
}

TEST(SceneCommands, ARunHasItsErrorInMetres) {
  const Result result = shell("odeum run spinning_pair");
  EXPECT_EQ(result.code, 0) << result.output;
  EXPECT_NE(result.output.find("error      odeum/rk4: 3.8"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("of the scene's size of 1 m"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("ms a step"), std::string::npos) << result.output;
}

}  // namespace
}  // namespace odeum::tests::scene_problem_test
