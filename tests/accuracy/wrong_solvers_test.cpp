// SPDX-License-Identifier: BSD-3-Clause
// Deliberately wrong solvers, put through the study of convergence as any other: none whose fault
// can be seen is confirmed.
#include "accuracy/wrong_solvers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "odeum/judge/amplification.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/studies/convergence/pair_runs.hpp"

namespace odeum::tests {
namespace {

struct Point {
  double wrong, right;  ///< errors in the same steps
  double certain;       ///< above it an error is no rounding
};

double error_of(const Case& c, const Entrant& entrant, std::uint64_t steps) {
  Request request;
  request.steps = steps;
  request.stops = c.stops;
  const Outcome outcome = entrant.solve(request);
  if (outcome.status != Status::ok) return std::numeric_limits<double>::infinity();
  double squares = 0;
  const std::vector<judge::StopError> errors = judge::Judge(c, c.stops).errors(outcome);
  for (const judge::StopError& e : errors)
    squares += e.error_rms * e.error_rms / static_cast<double>(errors.size());
  return std::sqrt(squares);
}

/// The errors of a study beside those of the same solver without its fault, where that solves the
/// case to 1 %.
std::vector<Point> side_by_side(const Case& c, double gain, const Entrant& right,
                                const study::ConvergenceResult& wrong) {
  const double scale = judge::Judge(c, c.stops).scale();
  std::vector<Point> points;
  for (const study::ConvergenceRow& row : wrong.rows) {
    judge::ErrorPoint rounding;
    rounding.steps = static_cast<double>(row.steps);
    rounding.rounding_unit = 0x1p-53 * gain;
    const double error = error_of(c, right, row.steps);
    if (error < 0.01 * scale) points.push_back({row.error_rms, error, rounding.certain_error()});
  }
  return points;
}

/// Whether the fault can be seen in the wrong solver's errors alone: among the finer steps, where
/// errors are no rounding, they vary beside the right ones by four times, or grow to four times
/// what they are at the coarsest. (At coarse steps a fault may do harm and vanish with the step.)
bool visible(const std::vector<Point>& points) {
  double low = std::max(1.0, points.front().wrong / points.front().right), high = 0;
  for (std::size_t i = points.size() / 2; i < points.size(); ++i) {
    if (points[i].wrong <= points[i].certain) continue;
    const double ratio = points[i].wrong / points[i].right;
    low = std::min(low, ratio);
    high = std::max(high, ratio);
  }
  return high > 4 * low;
}

class Wrong : public testing::TestWithParam<std::size_t> {};

TEST_P(Wrong, IsNotConfirmedWhereItCanBeSeen) {
  const Case& c = campaign_cases()[GetParam()];
  const double gain = judge::perturbation_gain(c);
  std::vector<WrongSolver> solvers = wrong_coefficients();
  for (const auto& more : {wrong_explicit_steps(), wrong_implicit_steps()})
    solvers.insert(solvers.end(), more.begin(), more.end());
  ASSERT_GE(solvers.size(), 60U);
  std::size_t seen = 0, tried = 0;
  for (const WrongSolver& solver : solvers) {
    if (solver.second_order && c.id != "second_order") continue;
    ++tried;
    const Entrant wrong = entrant_of(solver.name, solver.claimed, solver.wrong, c);
    const Entrant right = entrant_of(solver.name, solver.claimed, solver.right, c);
    const auto result = study::converge_pair({&c, &wrong, Mode::fixed}, {.gain = gain}, false);
    const judge::OrderFit& fit = result.orders.front().fit;
    const std::vector<Point> points = side_by_side(c, gain, right, result);
    if (points.empty() || !visible(points)) continue;
    ++seen;
    const bool denied = fit.verdict == judge::Verdict::lower ||
                        fit.verdict == judge::Verdict::floors ||
                        fit.verdict == judge::Verdict::undetermined;
    EXPECT_TRUE(denied) << solver.name << " is " << to_string(fit.verdict) << ", order "
                        << fit.order;
  }
  EXPECT_GE(seen, tried / 3);  // the campaign has faults to find
}

/// The same solvers without their faults are right.
TEST_P(Wrong, WithoutItsFaultIsConfirmed) {
  const Case& c = campaign_cases()[GetParam()];
  const double gain = judge::perturbation_gain(c);
  std::vector<WrongSolver> solvers{wrong_coefficients().front()};
  for (const auto& more : {wrong_explicit_steps(), wrong_implicit_steps()})
    for (const WrongSolver& solver : more)
      if (solver.name.find("started") != std::string::npos ||
          solver.name.find("late velocity") != std::string::npos ||
          solver.name.find("one Jacobian") != std::string::npos)
        solvers.push_back(solver);
  for (const WrongSolver& solver : solvers) {
    if (solver.second_order && c.id != "second_order") continue;
    const Entrant right = entrant_of(solver.name, solver.claimed, solver.right, c);
    const auto result = study::converge_pair({&c, &right, Mode::fixed}, {.gain = gain}, false);
    const judge::OrderFit& fit = result.orders.front().fit;
    EXPECT_EQ(fit.verdict, judge::Verdict::confirmed)
        << solver.name << " without its fault: " << fit.order << ' ' << fit.reason;
  }
}

INSTANTIATE_TEST_SUITE_P(Campaign, Wrong, testing::Range(std::size_t{0}, std::size_t{6}),
                         [](const auto& of) { return campaign_cases()[of.param].id; });

}  // namespace
}  // namespace odeum::tests
