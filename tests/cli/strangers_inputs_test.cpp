// SPDX-License-Identifier: BSD-3-Clause
// Inputs that strangers brought, as commands; their right values were computed apart.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::strangers_inputs_test {
namespace {

/// `odeum` in a folder with a file of its own, its.yaml.
class StrangersInput {
 public:
  explicit StrangersInput(const std::string& text) {
    write_text(folder_.path() / "its.yaml", text);
  }
  Result operator()(const std::string& words) const {
    return shell("cd '" + folder_.path().string() + "' && XDG_CACHE_HOME=$PWD odeum " + words);
  }
  nlohmann::json runs(const std::string& words) const {
    const Result result = (*this)("run its.yaml --format json " + words + " 2>/dev/null");
    EXPECT_EQ(result.code, 0) << result.output;
    return nlohmann::json::parse(result.output).at("runs");
  }

 private:
  TemporaryFolder folder_;
};

double at_end(const nlohmann::json& run, const char* state) {
  return run["states"].back()["y"][state];
}

// A force that jumps with the position: implicit methods ended up to 236 off with status ok. The
// error allowed is 1e3 times the tolerance times an amplification of some 10.
TEST(StrangersInput, AForceThatJumpsWithThePosition) {
  const StrangersInput input(
      "states: {x: 0, v: 1}\nequations: {x: v, v: 'if(x > 0.5, -50, 1)'}\ntime: {end: 10}\n");
  const nlohmann::json runs = input.runs(
      "--tol 1e-8 --no-truth --solver radau_iia5 --solver radau_iia9 --solver radau_iia_variable "
      "--solver gauss6");
  ASSERT_EQ(runs.size(), 4U);
  for (const auto& run : runs) {
    EXPECT_EQ(run["status"], "ok") << run;
    EXPECT_NEAR(at_end(run, "x"), -0.35420936, 1e-4) << run["solver"];
    EXPECT_NEAR(at_end(run, "v"), -0.53998267, 1e-4) << run["solver"];
  }
}

// A concentration that decays fast falls below zero by CVODE's corrections, and not under its own
// constraints, outputs included. What they refuse is said.
TEST(StrangersInput, ConcentrationsStayAboveZeroUnderConstraints) {
  const StrangersInput input(
      "states: {a: 1, b: 0}\nequations: {a: -1000*a, b: 1000*a}\ntime: {end: 10}\n");
  const std::string run = "run its.yaml --solver cvode/bdf --rtol 1e-2 --atol 1e-2 ";
  const std::string lowest =
      " --every 0.005 --out out >/dev/null 2>&1; grep bdf out/trajectory.csv | cut -d , -f 6 | "
      "sort -g | head -n 1";
  EXPECT_LT(std::stod(input(run + lowest).output), -1e-3);
  EXPECT_GE(std::stod(input(run + "--option constraints=1" + lowest).output), 0);
  // The printed program has them.
  const Result program = input(run + "--option constraints=1 --code");
  EXPECT_NE(program.output.find("N_VConst(1, constraints);"), std::string::npos) << program.output;
  EXPECT_EQ(input(run + "--code").output.find("onstraints"), std::string::npos);
  const Result refused = input(run + "--option constraints=2");
  EXPECT_NE(refused.output.find("y0 fails to satisfy constraints"), std::string::npos)
      << refused.output;
}

// The derivative of the branch that is not taken was NaN. h reaches 0 at t = 1, and leaves it as
// (t - 1)^2 / 4.
TEST(StrangersInput, ABranchThatGuardsARoot) {
  const StrangersInput input(
      "states: {h: -1}\nequations: {h: 'if(h > 0, sqrt(h), 1)'}\ntime: {end: 2}\n");
  for (const auto& run :
       input.runs("--tol 1e-8 --no-truth --solver rodas4 --solver radau_iia5 --solver sdirk4"))
    EXPECT_NEAR(at_end(run, "h"), 0.25, 1e-3) << run["solver"];
}

// The edge of stability of explicit Euler on an oscillator of quality Q is 1/Q, 0.01, and not that
// of another mode, 0.717.
TEST(StrangersInput, WhyNamesTheEdgeOfAnOscillatorOfHighQuality) {
  const StrangersInput input(
      "states: {X: 1, P: 0}\nequations: {X: P, P: -P/100 - X}\ntime: {end: 500}\n");
  const Result why = input("why its.yaml --solver explicit_euler --step 0.0125");
  EXPECT_NE(why.output.find("a step of 0.0125 is 1.25 times what is stable (0.00"),
            std::string::npos)
      << why.output;
}

// The slope is infinite at t = 1.5 and the solution is not: y(3) = 2 sqrt(1.5) + 2 sqrt(1.5). A run
// that has it was called wrong.
TEST(StrangersInput, ASlopeWithoutBoundIsNoEndOfTheSolution) {
  const StrangersInput input(
      "states: {y: 0}\nequations: {y: 1/sqrt(abs(t - 1.5))}\ntime: {end: 3}\n");
  const auto runs = input.runs("--tol 1e-6 --solver dormand_prince54 --solver rodas4");
  for (const auto& run : runs) {
    EXPECT_NE(run["answer"], "wrong") << run;
    if (run["status"] != "ok") continue;
    EXPECT_NEAR(at_end(run, "y"), 4.898979, 1e-3) << run["solver"];
  }
  EXPECT_EQ(runs[0]["status"], "ok") << runs;
}

// A body with dry friction comes to rest. The slowness was put down to the derivative of its own
// right-hand side, which is right.
TEST(StrangersInput, WhyNamesSlidingWhereFrictionHoldsABody) {
  const StrangersInput input(
      "parameters: {k: 100, m: 1, F: 10}\nstates: {x: 1, v: 0}\n"
      "equations: {x: v, v: -k/m*x - F/m*sign(v)}\ntime: {end: 10}\n");
  const Result why = input("why its.yaml --solver cvode/bdf --tol 1e-6 --until 1.58");
  EXPECT_NE(why.output.find("both sides lead there"), std::string::npos) << why.output;
  EXPECT_EQ(why.output.find("Jacobian given"), std::string::npos) << why.output;
}

// At rest but for the rounding of positions: an energy of 1.3e-27 J was called a blow-up.
TEST(StrangersInput, AnEnergyOfRoundingIsNoBlowUp) {
  const StrangersInput input(
      "gravity: 0\ncloth:\n  - rows: 5\n    columns: 5\n    origin: [0, 0, 0]\n    row_edge: [1, "
      "0, 0]\n    column_edge: [0, 1, 0]\n    mass: 1000\n    structural: {stiffness: 1e5, "
      "damping: "
      "0}\n    shear: {stiffness: 1e5, damping: 0}\n");
  const Result run = input("run its.yaml --solver rk4 --step 0.001 --until 1");
  EXPECT_EQ(run.code, 0) << run.output;
  EXPECT_EQ(run.output.find("blown up"), std::string::npos) << run.output;
}

}  // namespace
}  // namespace odeum::tests::strangers_inputs_test
