// SPDX-License-Identifier: BSD-3-Clause
// What an answer of odeum advise says, and whether its command keeps it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "advise/answers.hpp"

namespace odeum::answer_test {
namespace {

using advise_tests::File, advise_tests::lines_with, advise_tests::number_after;
using tests::Result, tests::shell;

// A box with friction: the solution stays where the right-hand side jumps, and the answer to t
// = 2.5 of 10, Euler's method with one step, was an answer.
TEST(Answer, SaysForWhichPartOfTheTimeItHasAnAnswer) {
  const File box(
      "parameters: {g: 9.8, mu: 0.3}\nstates: {v: 10}\nequations: {v: -sign(v)*g*mu}\n"
      "time: {end: 10}\n");
  const Result part = shell("odeum advise " + box.word() + "--error 1e-4 --solver explicit_euler");
  if (part.code != 0) {  // the truth may come to know the rest
    EXPECT_EQ(part.code, 1);
    EXPECT_EQ(part.output.find("no answer beyond t = 2.5 of 10; up to there: "), 0U) << part.output;
  }
  const Result asked =
      shell("odeum advise " + box.word() + "--error 1e-4 --solver explicit_euler --until 2.5");
  EXPECT_EQ(asked.code, 0) << asked.output;
  EXPECT_NE(asked.output.find("--until 2.5 --solver odeum/explicit_euler"), std::string::npos)
      << asked.output;
}

// The cheapest fixed step that divides a frame and keeps the error at each: of a game.
TEST(Answer, KeepsAnErrorAtEveryFrame) {
  const File pendulum("states: {q: 1, v: 0}\nequations: {q: v, v: -9.81*sin(q)}\ntime: {end: 2}\n");
  const Result result = shell("odeum advise " + pendulum.word() +
                              "--error 1e-3 --frame 1/60 --solver rk4 midpoint --format json");
  ASSERT_EQ(result.code, 0) << result.output;
  const auto advice = nlohmann::json::parse(result.output);
  EXPECT_EQ(advice["setting_kind"], "step");
  EXPECT_NEAR(double(advice["setting"]) * double(advice["steps_per_frame"]), 1.0 / 60, 1e-15);
  EXPECT_LE(advice["error"], 1e-3);
  // A run to each of some frames by the same steps.
  const std::string command = advice["command"];
  for (const int frame : {1, 60, 77, 119}) {
    const Result run = shell(command + fmt::format(" --until {}", frame / 60.0));
    EXPECT_LE(number_after(run.output, "error "), 1e-3) << run.output;
  }
}

// Whatever was asked for, the command that is printed runs as it stands, and keeps the error.
TEST(Answer, HasACommandThatRunsForEveryFormOfQuestion) {
  const tests::TemporaryFolder root;
  const std::string file = (root.path() / "it's a decay.yaml").string();
  tests::write_text(file,
                    "parameters: {k: 1, d: 1}\nstates: {y: 1}\nequations: {y: -k*y^2*d}\n"
                    "time: {end: 1}\ncases:\n  slow: {}\n  fast: {set: {k: 2}}\n");
  const std::string text = fmt::format("\"{}\" --case fast --error 1e-5", file);
  for (const std::string& question :
       {text, text + " --set d=3", text + " --set d=3 --set k=0.5 --vary d=1..2",
        text + " --until 0.5 --set d=2", text + " --frame 1/60", text + " --frame 1/60 --until 0.5",
        fmt::format("\"{}\" --case slow --time 5us", file),
        fmt::format("\"{}\" --case slow --time 5us --frame 1/50", file),
        std::string("kepler_e06 --error 1e-5 --until 2"),
        std::string("kepler_e06 --error 1e-3 --energy 1e-5 --horizon 10"),
        std::string("kepler_e06 --error 1e-3 --vary eccentricity=0.1..0.5"),
        std::string("robertson --error 1e-5")}) {
    const Result result = shell("odeum advise " + question + " --solver rk4 'dorm*' --format json");
    ASSERT_EQ(result.code, 0) << question << "\n" << result.output;
    const auto advice = nlohmann::json::parse(result.output);
    const std::string command = advice["command"];
    const Result run = shell(command);
    EXPECT_EQ(run.code, 0) << command << "\n" << run.output;
    // `odeum run` prints six digits.
    EXPECT_LE(number_after(run.output, "error "), double(advice["error"]) * (1 + 1e-5)) << command;
  }
}

// The error was that of the largest coordinate, so that particles were 1.27 mm off.
TEST(Answer, KeepsTheDistanceOfEachParticleAtEveryFrame) {
  const Result result = shell(
      "odeum advise spherical_pendulum --until 2 --error 1e-3 --frame 1/60 --solver 'odeum/dorm*' "
      "--format json");
  ASSERT_EQ(result.code, 0) << result.output;
  const auto advice = nlohmann::json::parse(result.output);
  const std::string command = advice["command"];
  const std::string solver = advice["solver"];
  // At each of the frames that the run keeps, every 60th of a second.
  const Result run = shell(command);
  EXPECT_LE(number_after(run.output, "error      " + solver + ": "), 1e-3) << run.output;
}

// At the quarters of the time the particle was 0.57 mm off, and 1.07 mm between two of them.
TEST(Answer, KeepsTheErrorOfASceneAllTheTime) {
  const auto advice = nlohmann::json::parse(
      shell("odeum advise spherical_pendulum --until 1 --error 1e-3 --solver rk4 --format json")
          .output);
  const Result run = shell(advice["command"]);
  // At 60 frames, of which some lie between the 64 times that were looked at.
  EXPECT_LE(number_after(run.output, "error      odeum/rk4: "), 1.01e-3) << run.output;
}

// The command named the parameter twice, which `odeum run` refuses.
TEST(Answer, VariesAParameterThatIsSetAsWell) {
  const File decay(
      "states: {y: 1}\nparameters: {k: 1, d: 1}\nequations: {y: -k*y^2*d}\ntime: {end: 1}\n");
  const auto advice = nlohmann::json::parse(
      shell("odeum advise " + decay.word() +
            "--set k=3 --set d=0.5 --vary k=1..2 --error 1e-5 --solver rk4 --format json")
          .output);
  const std::string command = advice["command"];
  EXPECT_EQ(command.find("--set k=3"), std::string::npos) << command;
  EXPECT_NE(command.find("--set d=0.5"), std::string::npos) << command;
  EXPECT_EQ(shell(command).code, 0) << command;
}

// It divided by the energy at the start: "the energy is not conserved", of one that is.
TEST(Answer, RefusesAnEnergyThatIsZero) {
  const File hill(
      "states: {q: 1, v: 1}\nequations: {q: v, v: q}\ninvariants: {energy: v*v/2 - q*q/2}\n"
      "time: {end: 1}\n");
  for (const std::string more : {"", " --horizon 3"}) {
    const Result result =
        shell("odeum advise " + hill.word() + "--error 1e-5 --energy 1e-5 --solver rk4" + more);
    EXPECT_EQ(result.code, 2) << result.output;
    EXPECT_NE(result.output.find("the energy is 0 at the start"), std::string::npos)
        << result.output;
  }
}

// Every reason stood in a line of its own, and the closed form of a linear problem in two.
TEST(Answer, SaysInOneLineWhichCandidatesWereDropped) {
  const Result result =
      shell("odeum advise damped_oscillator_underdamped --error 1e-6 --solver 'odeum/*' 'gsl/*'");
  EXPECT_EQ(result.code, 0) << result.output;
  for (const char* once : {"dropped ", "not tried ", "apart "})
    EXPECT_EQ(lines_with(result.output, once), 1U) << once << "\n" << result.output;
}

// A decaying solution of a problem that also has a growing motion. Steps of an L-stable method
// damp that, so that the answer holds for no other start.
TEST(Answer, SaysThatItsStepsDampWhatGrows) {
  const File saddle("states: {x: 1, y: -1}\nequations: {x: y, y: x}\ntime: {end: 12}\n");
  const Result damped =
      shell("odeum advise " + saddle.word() + "--error 0.1 --solver implicit_euler");
  EXPECT_NE(damped.output.find("\ngrowth    a change of the start by a millionth is"),
            std::string::npos)
      << damped.output;
}

// A run of few steps was bound by stability, since ten times the tolerance took as many.
TEST(Answer, CallsStabilityALimitOnlyWhereAnEigenvalueIsAtTheEdge) {
  const File stiff("states: {y: 2}\nequations: {y: -1000*(y - cos(t)) - sin(t)}\ntime: {end: 4}\n");
  EXPECT_NE(shell("odeum advise " + stiff.word() + "--error 1e-4 --solver dormand_prince54")
                .output.find("\nlimit     stability\n"),
            std::string::npos);
  const File slow("states: {y: 1}\nequations: {y: -0.1*y}\ntime: {end: 1}\n");
  EXPECT_EQ(shell("odeum advise " + slow.word() + "--error 1e-4 --solver dormand_prince54")
                .output.find("\nlimit     stability\n"),
            std::string::npos);
}

// Twice the step is beyond the edge, and a step that is a tenth longer already misses the error.
TEST(Answer, CallsAccuracyTheLimitWhereALittleLongerStepMissesTheError) {
  const File dimer(
      "parameters: {k: 1e6, kr: 0.1}\nstates: {A: 1e-6, D: 0}\n"
      "equations: {A: -2*k*A^2 + 2*kr*D, D: k*A^2 - kr*D}\ntime: {end: 20}\n");
  const Result result = shell("odeum advise " + dimer.word() + "--error 1e-5 --solver rk4");
  EXPECT_EQ(lines_with(result.output, "limit     accuracy"), 1U) << result.output;
  EXPECT_EQ(lines_with(result.output, "stops     t = 5, 10, 15, 20: the error is the largest"), 1U)
      << result.output;
}

// Its right-hand side has a sign of the velocity alone, and was handed none.
TEST(Answer, IsGivenForFrictionThatHasNoDerivative) {
  const File block("states: {x: 0, v: 4}\nequations: {x: v, v: -1.962*sign(v)}\ntime: {end: 5}\n");
  const Result result = shell("odeum advise " + block.word() +
                              "--error 1e-4 --solver 'odeint/symplectic*' velocity_verlet rk4");
  EXPECT_EQ(result.code, 1) << result.output;
  EXPECT_EQ(result.output.find("no answer beyond t = "), 0U) << result.output;
}

}  // namespace
}  // namespace odeum::answer_test
