// SPDX-License-Identifier: BSD-3-Clause
// odeum advise as a user runs it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "advise/answers.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::advise_test {
namespace {

using advise_tests::number_after;
using tests::Result;
using tests::shell;

/// The advice keeps to the error, and its command gives the error and the counts that it says.
void expect_true(const std::string& arguments, double asked) {
  const Result result = shell("odeum advise " + arguments + " --format json");
  ASSERT_EQ(result.code, 0) << result.output;
  const auto advice = nlohmann::json::parse(result.output);
  for (const char* key :
       {"solver", "setting_kind", "setting", "absolute", "error", "error_low", "error_high",
        "time_ns", "time_low", "time_high", "limited_by", "runners_up", "not_tried", "command"})
    EXPECT_TRUE(advice.contains(key)) << key;
  EXPECT_LE(advice["error"], asked);
  EXPECT_GT(advice["time_ns"], 0);
  EXPECT_NE(advice["solver"], "odeum/exponential_propagator");
  const std::string command = advice["command"];
  const Result run = shell(command);
  EXPECT_EQ(run.code, 0) << command << "\n" << run.output;
  EXPECT_LE(number_after(run.output, "error "), asked) << command << "\n" << run.output;
  EXPECT_EQ(number_after(run.output, "cost "), advice["command_rhs_evaluations"]) << run.output;
  // `odeum run` prints six digits.
  const double error = advice["command_error"];
  EXPECT_NEAR(number_after(run.output, "error "), error, 1e-5 * error) << run.output;
}

TEST(Advise, ItsCommandMakesTheRunAgain) {
  expect_true("kepler_e06 --error 1e-5 --solver 'odeum/dorm*' 'gsl/rk*'", 1e-5);
  // Fixed steps win, and a propagator that does not take part in this race is faster.
  expect_true("damped_oscillator_underdamped --error 1e-6 --library odeum", 1e-6);
}

// Runs of milliseconds, so that those to the first stop order the race. Explicit methods are bound
// by stability there, and take hundreds of times as long.
TEST(Advise, OrdersDearRunsByTheirFirstStop) {
  expect_true(
      "brusselator_1d --error 1e-3 --seconds 600 --solver odeum/rodas4 odeum/radau_iia5 "
      "odeum/dormand_prince54 odeum/rk4",
      1e-3);
}

// The first stop is 1e-11 of the last: taken for that share of the work, it made every run seem to
// take seconds, and no candidate had its turn.
TEST(Advise, KnowsThatStopsMayBeDecadesApart) {
  expect_true("robertson --error 1e-9 --seconds 600 --library odeum", 1e-9);
}

/// The advice within a time keeps to it, and its command makes the run again.
nlohmann::json expect_within(const std::string& arguments, double ns) {
  const Result result = shell("odeum advise " + arguments + " --format json");
  EXPECT_EQ(result.code, 0) << result.output;
  if (result.code != 0) return {};
  auto advice = nlohmann::json::parse(result.output);
  EXPECT_EQ(advice["time_asked"], ns);
  const Result run = shell(advice["command"]);
  EXPECT_EQ(number_after(run.output, "cost "), advice["command_rhs_evaluations"]) << run.output;
  const double error = advice["command_error"];
  EXPECT_NEAR(number_after(run.output, "error "), error, 1e-5 * error) << run.output;
  return advice;
}

// Times that the runs take on any machine, so that there is an answer.
TEST(Advise, FindsTheLeastErrorWithinATime) {
  const auto advice = expect_within(
      "kepler_e06 --time 20ms --seconds 4 --solver 'odeum/dorm*' odeum/rk4 'gsl/rk*'", 2e7);
  EXPECT_LE(advice["time_ns"], 2e7);
  // An eighth-order method has as much as double precision in some 20 us.
  EXPECT_LT(advice["error"], 1e-12);
}

TEST(Advise, FindsStepsThatDivideAFrame) {
  const auto advice = expect_within(
      "kepler_e06 --frame 1/60 --time 0.5ms --seconds 4 --solver 'odeum/dorm*' odeum/rk4 "
      "odeum/bdf_variable",
      5e5);
  EXPECT_LE(advice["frame_ns"], 5e5);
  EXPECT_EQ(advice["setting_kind"], "step");
  const double setting = advice["setting"], steps = advice["steps_per_frame"];
  EXPECT_NEAR(setting * steps, 1.0 / 60, 1e-15);
  const Result none = shell("odeum advise kepler_e06 --frame 0.11 --time 1ms");
  EXPECT_EQ(none.code, 1) << none.output;
  EXPECT_NE(none.output.find("frames of 0.11 do not divide the run of 3"), std::string::npos)
      << none.output;
}

// The race was run first.
TEST(Advise, AFolderThatCannotBeWrittenIsRefusedBeforeTheRace) {
  const Result none = shell("odeum advise kepler_e06 --error 1e-6 --seconds 30 --out /dev/null/x");
  EXPECT_EQ(none.code, 4) << none.output;
  EXPECT_EQ(none.output.find("error 1e-06"), std::string::npos) << none.output;
}

// The seconds contain the truth's: where they do not suffice for it, what is known says so, and it
// is not kept for the next.
TEST(Advise, ItsSecondsContainTheTruth) {
  const tests::TemporaryFolder folder;
  const Result result = shell("XDG_CACHE_HOME='" + folder.path().string() +
                              "' odeum advise flag --error 1e-3 --seconds 1 --solver odeum/rk4");
  // An answer on the part that is known, or none.
  EXPECT_LE(result.code, 1) << result.output;
  EXPECT_NE(result.output.find("the seconds are spent at t = "), std::string::npos)
      << result.output;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder.path()))
    EXPECT_NE(entry.path().extension(), ".reference");
}

TEST(Advise, AnswersForTextsAndTheirParameters) {
  const tests::TemporaryFolder root;
  const std::string file = (root.path() / "a decay.yaml").string();
  tests::write_text(file,
                    "states: {y: 1}\nparameters: {k: 1}\nequations: {y: -k*y^2}\ntime: {end: 1}\n");
  expect_true("'" + file + "' --set k=2 --error 1e-6 --solver 'odeum/rk*' 'odeum/dorm*'", 1e-6);
}

TEST(Advise, KeepsToTheErrorOverABoxOfParameters) {
  const tests::TemporaryFolder root;
  const std::string file = (root.path() / "box.yaml").string();
  tests::write_text(file,
                    "states: {y: 1}\nparameters: {k: 1, d: 0}\n"
                    "equations: {y: -k*y^2 + d*cos(t)}\ntime: {end: 1}\n");
  const Result result =
      shell("odeum advise '" + file +
            "' --vary k=0.1..10 --vary d=0..2 --error 1e-6 --solver 'odeum/dorm*' --format json");
  ASSERT_EQ(result.code, 0) << result.output;
  const auto advice = nlohmann::json::parse(result.output);
  ASSERT_EQ(advice["box"].size(), 5U);  // the middle and four corners
  EXPECT_EQ(advice["box"][0]["parameters"], "k=1 d=1");
  double largest = 0;
  for (const auto& point : advice["box"]) {
    EXPECT_LE(point["error"], 1e-6);
    largest = std::max<double>(largest, point["error"]);
  }
  EXPECT_EQ(advice["error"], largest);
  // The setting that was advised, at the worst corner as `odeum run` makes it.
  const Result run = shell(advice["command"]);
  EXPECT_EQ(run.code, 0) << run.output;
  const double error = advice["command_error"];
  EXPECT_NEAR(number_after(run.output, "error "), error, 1e-5 * error) << run.output;
}

// Symplectic methods or small errors: the energy of an orbit over 300 periods.
TEST(Advise, KeepsTheEnergyUpToAHorizon) {
  const std::string words = "odeum advise kepler_e06 --error 1e-3 --solver 'odeum/dorm*' ";
  const auto plain = nlohmann::json::parse(shell(words + "--format json").output);
  const auto long_run = nlohmann::json::parse(
      shell(words + "--energy 1e-6 --horizon 2000 --seconds 600 --format json").output);
  EXPECT_LE(long_run["energy_error"], 1e-6);
  EXPECT_LT(long_run["error"], plain["error"]);
  const auto at_stops = nlohmann::json::parse(shell(words + "--energy 1e-6 --format json").output);
  EXPECT_LE(at_stops["energy_error"], 1e-6);
}

TEST(Advise, SaysWhereNobodyReachesTheError) {
  const Result none =
      shell("odeum advise kepler_e06 --error 1e-12 --solver odeum/explicit_euler --seconds 0.3");
  EXPECT_EQ(none.code, 1) << none.output;
  EXPECT_NE(none.output.find("nobody here reaches that"), std::string::npos) << none.output;
  // The reference has 25 digits and is read as doubles.
  const Result floor = shell("odeum advise kepler_e06 --error 1e-20");
  EXPECT_EQ(floor.code, 1) << floor.output;
  EXPECT_NE(floor.output.find("the solution itself is known to"), std::string::npos)
      << floor.output;
  // There was no race.
  EXPECT_EQ(floor.output.find("dropped"), std::string::npos) << floor.output;
}

TEST(Advise, RefusesWhatIsNoQuestion) {
  for (const std::string arguments :
       {"kepler_e06 --error 1e-3 --time 1ms", "kepler_e06 --frame 1/60",
        "kepler_e06 --error 1e-3 --until -1", "kepler_e06 --error 1e-3 --solver no_such_method",
        "kepler_e06 --error 1e-3 --frame 1e-9", "kepler_e06 --time 1xs", "kepler_e06 --time -1ms",
        "kepler_e06 --time 1ms --frame 1/0", "kepler_e06 --error 0", "kepler_e06 --error nan",
        "kepler_e06", "kepler_e06 --error 1e-3 --horizon 10",
        "kepler_e06 --error 1e-3 --energy 1e-3 --horizon 1", "vdp_mu1 --error 1e-3 --energy 1e-3",
        "kepler_e06 --time 1ms --energy 1e-3", "lorenz_kehlet_logg --error 1e-3 --vary q=1..2",
        "lotka_volterra --error 1e-3 --vary alpha=2..1", "kepler_e06 --error 1e-3 --library nobody",
        "kepler_e06 --error 1e-3 --solver bullet/*"})
    EXPECT_EQ(shell("odeum advise " + arguments).code, 2) << arguments;
}

}  // namespace
}  // namespace odeum::advise_test
