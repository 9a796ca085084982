// SPDX-License-Identifier: BSD-3-Clause
// What the study of convergence says where the budget ends its runs.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "odeum/studies/convergence/pair_runs.hpp"
#include "support/catalogue.hpp"
#include "support/own_runs.hpp"

namespace odeum::tests::budget_test {
namespace {

study::ConvergenceResult within(std::uint64_t evaluations, Mode mode, const char* solver) {
  Case c = find_case("robertson_40");
  c.nature.smooth = true;                          // whose budget is the case's own
  c.settings.evaluation_budget = 2 * evaluations;  // of which a quick study has half
  const Entrant entrant = find_entrant(c, solver);
  const study::CaseMeasures measures{
      .gain = 1,
      .amplification = {
          .at_stops = std::vector<double>(c.stops.size(), 1), .controls = {}, .unknown = {}}};
  return study::converge_pair({&c, &entrant, mode}, measures, true);
}

double number_after(const std::string& text, const std::string& words) {
  const std::size_t at = text.find(words);
  return at == std::string::npos ? std::nan("") : std::stod(text.substr(at + words.size()));
}

// Evaluations that the run would take, by a run that may.
double evaluations_of(Mode mode, const char* solver, double setting) {
  const Case& c = find_case("robertson_40");
  Request request;
  request.mode = mode;
  request.stops = c.stops;
  if (mode == Mode::fixed)
    request.steps = static_cast<std::uint64_t>(setting);
  else
    set_tolerance(request, c, setting);
  const Outcome outcome = find_entrant(c, solver).solve(request);
  EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
  return static_cast<double>(outcome.counters.work);
}

TEST(Budget, ThatEndsALadderOfStepsIsNoFailureAndSaysWhatTheNextOneTakes) {
  const auto result = within(10'000, Mode::fixed, "odeum/implicit_euler");
  const judge::OrderFit& fit = result.orders.front().fit;
  ASSERT_EQ(fit.verdict, judge::Verdict::undetermined) << fit.reason;
  ASSERT_NE(fit.reason.find("more than the budget"), std::string::npos) << fit.reason;
  EXPECT_EQ(fit.why, judge::NoOrder::budget_ends);
  double next = 0;  // the first steps over the budget
  std::size_t over = 0;
  for (const study::ConvergenceRow& row : result.rows) {
    if (row.status != "over_budget") continue;
    if (over++ == 0) next = static_cast<double>(row.steps);
    EXPECT_NE(row.detail.find("10000 evaluations"), std::string::npos) << row.detail;
  }
  EXPECT_GE(over, 1U);
  const double said = number_after(fit.reason, "steps take about ");
  EXPECT_EQ(number_after(fit.reason.substr(fit.reason.rfind("; ")), "; "), next) << fit.reason;
  // One digit, from the work of coarser steps, which falls a little for each.
  const double taken = evaluations_of(Mode::fixed, "odeum/implicit_euler", next);
  EXPECT_GT(said, 0.5 * taken) << fit.reason;
  EXPECT_LT(said, 2 * taken) << fit.reason;
}

TEST(Budget, ThatEndsALadderOfTolerancesSaysWhatTheNextOneTakes) {
  const auto result = within(1'250, Mode::adaptive, "odeum/tr_bdf2");
  const judge::OrderFit& fit = result.orders.front().fit;
  ASSERT_EQ(fit.verdict, judge::Verdict::undetermined) << fit.reason;
  const double tolerance = number_after(fit.reason, "a tolerance of "),
               said = number_after(fit.reason, "takes about ");
  ASSERT_GT(said, 1'250) << fit.reason;
  const double taken = evaluations_of(Mode::adaptive, "odeum/tr_bdf2", tolerance);
  // The foreseen cost follows the rate between the last two tolerances.
  EXPECT_GT(said, 0.4 * taken) << fit.reason;
  EXPECT_LT(said, 2.5 * taken) << fit.reason;
}

// Nothing was measured, so that nothing is judged: not `undetermined`, which counts as a judged
// pair.
TEST(Budget, ThatEndsEveryRunIsAVerdictOfItsOwn) {
  const auto result = within(40, Mode::fixed, "odeum/implicit_euler");
  const judge::OrderFit& fit = result.orders.front().fit;
  EXPECT_EQ(fit.verdict, judge::Verdict::over_budget);
  EXPECT_EQ(fit.why, judge::NoOrder::over_budget);
  EXPECT_NE(fit.reason.find("no run was solved within the budget"), std::string::npos)
      << fit.reason;
  for (const study::ConvergenceRow& row : result.rows) {
    EXPECT_EQ(row.status, "over_budget");
    EXPECT_EQ(row.judged.answer, judge::Answer::none) << "no answer is claimed";
  }
}

// What fails by itself is not put down to the budget.
TEST(Budget, IsNotBlamedForAFailure) {
  const auto result = within(30'000, Mode::fixed, "odeum/rk4");
  const judge::OrderFit& fit = result.orders.front().fit;
  EXPECT_EQ(fit.verdict, judge::Verdict::failed) << fit.reason;
  EXPECT_EQ(fit.why, judge::NoOrder::unstable);
  EXPECT_EQ(fit.reason.find("budget"), std::string::npos) << fit.reason;
}

}  // namespace
}  // namespace odeum::tests::budget_test
