// SPDX-License-Identifier: BSD-3-Clause
// odeum why on runs whose causes are known by how they were made, and as a user runs it.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "odeum/why/why_answer.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"
#include "why/made_failures.hpp"

namespace odeum::why_test {
namespace {

using tests::MadeFailure;
using tests::Result;
using tests::shell;

// Far more than the answers take, so that they do not depend on the machine.
constexpr double seconds = 300;

/// What is missing, and what is said that is not so; empty: right.
std::string fault_of(const MadeFailure& made) {
  const Case c = tests::made_case(made);
  if (!c.entrants.find(made.solver)) return {};  // a build without that library
  const why::Why why = tests::why_of(made, c, tests::made_request(made, c), seconds);
  std::set<why::Cause> said;
  for (const why::Finding& finding : why.findings) said.insert(finding.cause);
  std::string fault;
  for (const why::Cause cause : made.causes)
    if (!said.contains(cause)) fault += fmt::format("; {} is not said", name_of(cause));
  for (const why::Cause cause : said)
    if (!made.causes.contains(cause) && !made.also.contains(cause))
      fault += fmt::format("; {} is not so", name_of(cause));
  if (!fault.empty()) fault = made.name + fault + "\n" + text_of(why, c, {made.name, ""});
  return fault;
}

TEST(Why, SaysTheCausesOfMadeFailures) {
  std::size_t right = 0, composed = 0;
  std::string faults;
  for (const MadeFailure& made : tests::made_failures()) {
    const std::string fault = fault_of(made);
    right += fault.empty();
    composed += made.causes.size() > 1;
    faults += fault;
    // What is denied by measurement is never said.
    EXPECT_EQ(fault.find("is not so"), std::string::npos) << fault;
  }
  EXPECT_GE(tests::made_failures().size(), 40U);
  EXPECT_GE(10 * composed, 3 * tests::made_failures().size());
  EXPECT_GE(10 * right, 9 * tests::made_failures().size()) << faults;
}

/// How far a state is from the right one, over the size of that.
double off(const std::vector<double>& state, const std::vector<double>& right) {
  double size = 0, most = 0;
  for (const double x : right) size = std::max(size, std::abs(x));
  for (std::size_t i = 0; i < right.size(); ++i)
    most = std::max(most, std::abs(state[state.size() - right.size() + i] - right[i]) / size);
  return most;
}

// A run to the end that is said to be better is nearer to what was computed apart, or as near for
// less work; where nothing is known, none or a shorter one is named.
TEST(Why, TheRunThatItNamesIsBetter) {
  int named = 0, unnamed = 0;  // where the end is known
  for (const MadeFailure& made : tests::made_failures()) {
    if (made.end.empty()) continue;
    const Case c = tests::made_case(made);
    if (!c.entrants.find(made.solver)) continue;
    const why::Why why = tests::why_of(made, c, tests::made_request(made, c), seconds);
    if (!why.better) {
      unnamed += !why.known_by.empty();
      continue;
    }
    ++named;
    const why::Other& other = why.others[*why.better];
    if (other.request.stops.back() < c.stops.back()) {
      EXPECT_TRUE(why.known_by.empty()) << made.name << " is known, and a shorter run is named";
      continue;
    }
    const Outcome theirs = c.entrants.find(other.id())->solve(other.request),
                  ours = c.entrants.find(made.solver)->solve(tests::made_request(made, c));
    ASSERT_EQ(theirs.status, Status::ok) << made.name;
    if (ours.status != Status::ok) {
      EXPECT_LT(off(theirs.states, made.end), 1e-4) << made.name;
      continue;
    }
    const double error = off(theirs.states, made.end), own = off(ours.states, made.end);
    EXPECT_TRUE(error < 0.5 * own || (error <= std::max(own, made.relative) &&
                                      theirs.counters.work < ours.counters.work))
        << made.name << ": " << error << " in place of " << own << "\n"
        << text_of(why, c, {made.name, ""});
  }
  EXPECT_GE(named, 5);
  // A solution that sticks and slips ten times, of which two families agree to 1e-3 only, and one
  // that slides, of which no other run is cheaper.
  EXPECT_LE(unnamed, 2);
}

/// What it says as a user runs it, and what its command gives.
TEST(Why, ItsCommandMakesTheBetterRun) {
  const tests::TemporaryFolder root;
  const std::string file = (root.path() / "stiff one.yaml").string();
  tests::write_text(file,
                    "states: {x: 1, y: 1}\nparameters: {k: 1}\n"
                    "equations: {x: -x, y: -k*(y - x^2)}\ntime: {end: 5}\n");
  const Result result = shell("odeum why '" + file +
                              "' --set k=1e4 --solver dormand_prince54 --tol 1e-6 --format json");
  ASSERT_EQ(result.code, 0) << result.output;
  const auto why = nlohmann::json::parse(result.output);
  EXPECT_EQ(why["causes"][0]["cause"], "stability");
  EXPECT_GT(why["causes"][0]["share"], 0.9);
  EXPECT_EQ(why["status"], "ok");
  const std::string summary = why["summary"], command = why["command"];
  EXPECT_NE(summary.find("y decays at 1e+04"), std::string::npos) << summary;
  const Result run = shell(command);
  EXPECT_EQ(run.code, 0) << command << "\n" << run.output;
  // A method for stiff problems takes no more steps than the slow component needs.
  const std::string steps = run.output.substr(run.output.find("\ntol "));
  int count = 0;
  ASSERT_EQ(std::sscanf(steps.substr(steps.find(',')).c_str(), ", %d steps", &count), 1) << steps;
  EXPECT_LT(count, why["steps"].get<int>() / 50);
}

// Roessler's band: errors grow slowly, and at t = 50 a run to a tolerance of 1e-3 is still within a
// tenth of the solution; a run that swings between two states of the other is not off.
TEST(Why, ARunThatEndedFarOffIsToldWhereItLeftAndWhichToleranceHolds) {
  const tests::TemporaryFolder root;
  const std::string file = (root.path() / "band.yaml").string();
  tests::write_text(file,
                    "states: {x: 1, y: 1, z: 0}\n"
                    "equations: {x: -y - z, y: x + 0.2*y, z: 0.2 + z*(x - 5.7)}\n"
                    "time: {end: 100}\n");
  const Result result =
      shell("odeum why " + file + " --solver dormand_prince54 --tol 1e-3 --format json");
  ASSERT_EQ(result.code, 0) << result.output;
  const auto why = nlohmann::json::parse(result.output);
  EXPECT_EQ(why["causes"][0]["cause"], "astray") << why;
  EXPECT_GT(why["causes"][0]["from"], 50) << why;
  bool near = false;
  for (const auto& other : why["others"])
    if (other["solver"] == "odeum/dormand_prince54") near = other["difference"] <= 0.02;
  EXPECT_TRUE(near) << why;
  EXPECT_NE(why["command"], "") << why;
}

// A concentration below its absolute tolerance: the same solver with another one is what to do, and
// the page draws a curve for each name.
TEST(Why, ATighterAbsoluteToleranceIsTheNextCommand) {
  const tests::TemporaryFolder root;
  const std::string file = (root.path() / "enzyme.yaml").string();
  tests::write_text(file,
                    "states: {s: 1e-6, c: 0, p: 0}\n"
                    "equations: {s: -1e6*(1e-8 - c)*s + 0.1*c, c: 1e6*(1e-8 - c)*s - 0.6*c, "
                    "p: 0.5*c}\ntime: {end: 100}\n");
  const std::string out = (root.path() / "out").string();
  const Result result =
      shell("odeum why " + file +
            " --solver dormand_prince54 --rtol 1e-6 --atol 1e-6 --format json --out " + out);
  ASSERT_EQ(result.code, 0) << result.output;
  const auto why = nlohmann::json::parse(result.output);
  EXPECT_EQ(why["causes"][0]["cause"], "absolute") << why;
  const std::string command = why["command"];
  EXPECT_NE(command.find("--solver odeum/dormand_prince54 --rtol 1e-06 --atol 1e-12"),
            std::string::npos)
      << why;
  const std::string trajectory = shell("cat " + out + "/trajectory.csv").output;
  EXPECT_NE(trajectory.find(",dormand_prince54,"), std::string::npos);
  EXPECT_NE(trajectory.find("dormand_prince54 --rtol 1e-06 --atol 1e-12"), std::string::npos);
}

TEST(Why, EndsARunThatFailed) {
  const tests::TemporaryFolder root;
  const std::string file = (root.path() / "pole.yaml").string();
  tests::write_text(file, "states: {y: 1}\nequations: {y: y^2}\ntime: {end: 2}\n");
  const Result run =
      shell("odeum run " + file + " --solver dormand_prince54 --tol 1e-6 --no-truth");
  EXPECT_EQ(run.code, 3) << run.output;
  EXPECT_NE(run.output.find("\nwhy     y grows beyond all bounds at t = 1"), std::string::npos)
      << run.output;
  EXPECT_NE(run.output.find("\nmore    odeum why " + file), std::string::npos) << run.output;
}

TEST(Why, CountsEventsAndNamesThoseWithoutEnd) {
  const tests::TemporaryFolder root;
  const auto why = [&](const char* equations, const char* events) {
    const std::string file = (root.path() / "events.yaml").string();
    tests::write_text(file, std::string("states: {x: 1, u: -1}\nequations: ") + equations +
                                "\ntime: {end: 3}\nevents:\n" + events);
    const Result said =
        shell("odeum why " + file + " --solver dormand_prince54 --tol 1e-6 --seconds 2");
    EXPECT_EQ(said.code, 0) << said.output;
    return said.output;
  };
  // At 0.5, 1.5 and 2.5: none of them is a kink of the equations.
  const std::string some = why(
      "{x: 2*u, u: 0}",
      "  - {when: x, falling: true, set: {u: 1}}\n  - {when: x - 2, rising: true, set: {u: -1}}\n");
  EXPECT_NE(some.find("3 of "), std::string::npos) << some;
  EXPECT_NE(some.find("steps end at events (the first at t = 0.5,"), std::string::npos) << some;
  EXPECT_EQ(some.find("kink"), std::string::npos) << some;
  const std::string without_end =
      why("{x: u, u: 0}",
          "  - {when: x, falling: true, set: {u: 1}}\n  - {when: x, rising: true, set: {u: -1}}\n");
  EXPECT_NE(without_end.find("ever faster"), std::string::npos) << without_end;
  EXPECT_EQ(without_end.find("\nkink"), std::string::npos) << without_end;
}

// Events are found by more runs over the same steps, which the evaluations of a run leave out.
TEST(Why, SegmentsOfARunWithEventsHaveItsEvaluations) {
  const tests::TemporaryFolder root;
  const std::string file = (root.path() / "room.yaml").string();
  tests::write_text(file,
                    "states: {x: 20, heat: 1}\nequations: {x: -0.1*x + 5*heat, heat: 0}\n"
                    "time: {end: 24}\nevents:\n"
                    "  - {when: x - 21, rising: true, set: {heat: 0}}\n"
                    "  - {when: x - 19, falling: true, set: {heat: 1}}\n");
  const auto said = nlohmann::json::parse(
      shell("odeum why " + file + " --solver dormand_prince54 --tol 1e-8 --format json").output);
  double sum = 0;
  for (const auto& segment : said["segments"]) sum += segment["rhs_evaluations"].get<double>();
  // Each segment is rounded, and has those at its ends.
  EXPECT_NEAR(sum, said["rhs_evaluations"].get<double>(), 0.02 * sum + 8);
}

TEST(Why, RefusesWhatIsNoQuestion) {
  for (const std::string arguments :
       {"kepler_e06 --solver rk4", "kepler_e06 --tol 1e-3", "kepler_e06 --solver rk4 --step 0",
        "kepler_e06 --solver nobody --tol 1e-3"})
    EXPECT_EQ(shell("odeum why " + arguments).code, 2) << arguments;
}

}  // namespace
}  // namespace odeum::why_test
