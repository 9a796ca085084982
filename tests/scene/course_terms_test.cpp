// SPDX-License-Identifier: BSD-3-Clause
// What scene files of a course's later assignments have: gravitation between particles, drag of a
// particle, other names and places of keys. And what a run says of such files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "odeum/cases/scene_case.hpp"
#include "odeum/input/yaml_tree.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/read/reader.hpp"
#include "support/catalogue.hpp"
#include "support/program.hpp"
#include "support/scene_texts.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::course_terms_test {
namespace {

using scene::Scene, scene::SceneProblem;
using tests::with_particles;

Scene read(const std::string& text) { return scene::read_scene("s.yaml", text).scene; }

void expect_fault(const std::string& text, const std::string& part) {
  try {
    read(text);
    ADD_FAILURE() << "read: " << text;
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

/// A light body around a heavy one: half the axis 1, eccentricity 0.6, G (m_a + m_b) = 1, so that
/// it is back after 2 pi; and the centre of mass rests.
std::string two_bodies(const std::string& solver) {
  constexpr double e = 0.6, light = 0.2;
  const double distance = 1 - e, speed = std::sqrt((1 + e) / (1 - e));
  return fmt::format(
      "duration: {:.17g}\nsolver: {}\nparticles:\n"
      "  - {{pos: [{:.17g}, 0, 0], vel: [0, {:.17g}, 0], mass: {}}}\n"
      "  - {{pos: [{:.17g}, 0, 0], vel: [0, {:.17g}, 0], mass: {}}}\n"
      "gravitational:\n  - {{particle_ids: [0, 1], G: 1}}\n",
      2 * M_PI, solver, -light * distance, -light * speed, 1 - light, (1 - light) * distance,
      (1 - light) * speed, light);
}

Outcome run(const Scene& scene, const std::string& solver, const Request& request) {
  return cases::enroll_scene(std::make_shared<const SceneProblem>(scene))
      .find("odeum/" + solver)
      ->solve(request);
}

TEST(Gravitation, ClosesKeplersEllipse) {
  const Scene scene = read(two_bodies("{type: dormand_prince853, tolerance: 1e-11, gravity: 0}"));
  const SceneProblem problem(scene);
  const std::vector<double>& start = problem.start();
  // An explicit method, and an implicit one, which takes the derivatives.
  for (const char* const solver : {"dormand_prince853", "radau_iia5"}) {
    const Outcome outcome = run(scene, solver, tests::adaptive_request(1e-11, {*scene.duration}));
    ASSERT_EQ(outcome.status, Status::ok) << solver << outcome.detail;
    for (std::size_t i = 0; i < start.size(); ++i)
      // A period amplifies errors by some 1e3, and a step's error is below its estimate or above.
      EXPECT_NEAR(outcome.states[i], start[i], 1e-6) << solver;
    // -G m_a m_b / (2 a)
    EXPECT_NEAR(problem.energy(outcome.states.data()), -0.8 * 0.2 / 2, 1e-7) << solver;
  }
}

TEST(Gravitation, TakesTheMassOfAFixedParticle) {
  // On a circle of radius 1 about a fixed mass of 4, G = 0.25.
  const Scene scene = read(
      "gravity: 0\nduration: 1.5\nsolver: {type: rk4, timestep: 0.001}\nparticles:\n"
      "  - {pos: [0, 0, 0], mass: 4, fixed: true}\n  - {pos: [1, 0, 0], vel: [0, 1, 0], mass: 3}\n"
      "gravitational: [{particle_ids: [1, 0], G: 0.25}]\n");
  const Outcome outcome = run(scene, "rk4", tests::fixed_request(1500, {1.5}));
  EXPECT_NEAR(outcome.states[3], std::cos(1.5), 1e-12);
  EXPECT_NEAR(outcome.states[4], std::sin(1.5), 1e-12);
}

TEST(ParticleDrag, ActsOnItsParticleAlone) {
  // v(t) = v0 exp(-c t / m) of the first; the second flies on.
  const Scene scene = read(
      "duration: 2\nsolver: {type: rk4, timestep: 1/500, gravity: 0.0}\nparticles:\n"
      "  - {pos: [0, 0, 0], vel: [3, 0, 1], mass: 2, drag: 0.5}\n"
      "  - {pos: [1, 0, 0], vel: [0, 1, 0], mass: 1}\n"
      "  - {pos: [5, 0, 0], mass: 1, fixed: true, drag: 1}\n");
  EXPECT_EQ(scene.solver->step, 1. / 500);
  const SceneProblem problem(scene);
  ASSERT_EQ(problem.structure().terms.size(), 1U);
  EXPECT_EQ(problem.structure().terms[0].count, 1U);
  EXPECT_TRUE(problem.structure().linear);
  // The second is of first order: h c / m = 5e-4 of a change of 2.
  for (const auto& [solver, near] :
       {std::pair{"rk4", 1e-11}, {"implicit_euler_linearised", 2e-3}}) {
    const Outcome outcome = run(scene, solver, tests::fixed_request(1000, {2}));
    ASSERT_EQ(outcome.status, Status::ok) << solver << outcome.detail;
    EXPECT_NEAR(outcome.states[9], 3 * std::exp(-0.5), near) << solver;
    EXPECT_NEAR(outcome.states[0], 12 * (1 - std::exp(-0.5)), near) << solver;
    EXPECT_NEAR(outcome.states[4], 2, near) << solver;
  }
}

// Terms that a scene does not have are not objects, and cost no call.
TEST(AbsentTerms, AreNotThere) {
  const SceneProblem bare(
      read(with_particles("springs: [{particle_ids: [0, 1], stiffness: 5, rest_length: 0.5}]\n")));
  EXPECT_TRUE(bare.plain());
  EXPECT_EQ(bare.structure().terms.size(), 1U);
  EXPECT_EQ(scene::make_gravitation(*bare.scene()), nullptr);
  EXPECT_EQ(scene::make_particle_drag(*bare.scene()), nullptr);
  EXPECT_TRUE(SceneProblem(read(with_particles("gravitational: []\n"))).structure().terms.empty());
}

TEST(CourseFiles, HaveOtherNamesAndPlacesOfKeys) {
  const auto choice = [](const std::string& solver) {
    return *read("gravity: 0\nsolver: " + solver + "\nparticles: [{pos: [0, 0, 0], mass: 1}]\n")
                .solver;
  };
  for (const char* const name : {"linearized_implicit", "linearised_implicit",
                                 "linearized_implicit_euler", "implicit_euler_linearised"})
    EXPECT_EQ(choice(fmt::format("{{type: {}, timestep: 0.1}}", name)).type,
              "implicit_euler_linearised");
  EXPECT_EQ(choice("{type: implicit_euler, timestep: 1/480}").type, "implicit_euler");
  EXPECT_EQ(choice("{type: implicit_euler, timestep: 1/480}").step, 1. / 480);
  EXPECT_EQ(choice("{type: rk4, timestep: 2 / 3}").step, 2. / 3);
  const auto gravity = [](const std::string& more, const std::string& top) {
    return read(top + "solver: {type: rk4, timestep: 0.1" + more +
                "}\nparticles: [{pos: [0, 0, 0], mass: 1}]\n")
        .gravity;
  };
  EXPECT_EQ(gravity("", ""), (scene::Vec3{0, 0, -9.81}));
  EXPECT_EQ(gravity(", gravity: 0.0", ""), (scene::Vec3{}));
  EXPECT_EQ(gravity(", gravity: 2", "up: y\n"), (scene::Vec3{0, -2, 0}));
  EXPECT_EQ(gravity(", gravity: [1, 2, 3]", ""), (scene::Vec3{1, 2, 3}));
  expect_fault(
      "gravity: 1\nsolver: {type: rk4, timestep: 0.1, gravity: 0}\n"
      "particles: [{pos: [0, 0, 0], mass: 1}]\n",
      "solver.gravity: gravity given twice");
  for (const char* const step : {"1/0", "1/-2", "a/3", "1/2/3", "/2", "-1/2"})
    expect_fault(fmt::format("solver: {{type: rk4, timestep: {}}}\n"
                             "particles: [{{pos: [0, 0, 0], mass: 1}}]\n",
                             step),
                 "solver.timestep");
  expect_fault(with_particles("gravitational: [{particle_ids: [0, 0], G: 1}]\n"),
               "gravitation from a particle to itself");
  expect_fault(with_particles("gravitational: [{particle_ids: [0, 7], G: 1}]\n"),
               "no such particle");
  expect_fault(with_particles("gravitational: [{particle_ids: [0, 1]}]\n"), "G");
}

/// The output and exit code of a run of a scene.
tests::Result run_of(const std::string& text, const std::string& options = "") {
  const tests::TemporaryFolder folder;
  std::ofstream(folder.path() / "scene.yaml") << text;
  return tests::shell("odeum run '" + (folder.path() / "scene.yaml").string() + "' --no-truth " +
                      options);
}

TEST(SceneRuns, SayWhichDampingTheSpringsHave) {
  const auto line = [](const std::string& keys) {
    const std::string out =
        run_of(with_particles("springs: [{particle_ids: [0, 1], stiffness: 5" + keys + "}]\n"))
            .output;
    const std::size_t at = out.find("\ndamping ");
    return at == std::string::npos ? "" : out.substr(at + 1, out.find('\n', at + 1) - at - 1);
  };
  EXPECT_EQ(line(""), "");
  EXPECT_NE(line(", damping: 0.1").find("the scene names no damping_model"), std::string::npos);
  EXPECT_EQ(line(", damping: 0.1, damping_model: axial"),
            "damping    axial: of the relative velocity along a spring");
  EXPECT_EQ(line(", damping: 0.1, damping_model: full"),
            "damping    full: of the whole relative velocity");
}

TEST(SceneRuns, TheEnergyOfRoundingIsNoBlowUp) {
  const std::string square =
      "duration: 1\ngravity: 0\nsolver: {type: implicit_euler_linearised, timestep: 0.004}\n"
      "cloth:\n  - rows: 5\n    columns: 5\n    origin: [0, 0, 0]\n    row_edge: [1, 0, 0]\n"
      "    column_edge: [0, 1, 0]\n    mass: 1000\n    structural: {stiffness: 1e5, damping: 0}\n"
      "    shear: {stiffness: 1e5, damping: 0}\n";
  const tests::Result rests = run_of(square, "--solver rk4 --step 0.001");
  EXPECT_EQ(rests.code, 0) << rests.output;
  EXPECT_EQ(rests.output.find("blown up"), std::string::npos) << rests.output;
  // What grows does so far above: the same with a step beyond the limit, and a push of 1e-6 m/s.
  const tests::Result grows =
      run_of(square + "    velocity: [{rows: [2, 2], columns: [2, 2], value: [1e-6, 0, 0]}]\n",
             "--solver explicit_euler --step 0.02");
  EXPECT_NE(grows.output.find("blown up"), std::string::npos) << grows.output;
  EXPECT_EQ(grows.code, 3);
}

TEST(SceneRuns, AttractionIsNoBlowUp) {
  const tests::Result kept =
      run_of(two_bodies("{type: velocity_verlet, timestep: 0.001, gravity: 0}"));
  EXPECT_EQ(kept.code, 0) << kept.output;
  EXPECT_EQ(kept.output.find("blown up"), std::string::npos) << kept.output;
}

}  // namespace
}  // namespace odeum::course_terms_test
