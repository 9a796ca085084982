// SPDX-License-Identifier: BSD-3-Clause
// Runs in extended precision: orders that double does not resolve, and the same equation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/cases/catalogue.hpp"
#include "odeum/kernel/explicit_rk.hpp"
#include "odeum/methods/verner98.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/studies/convergence/pair_runs.hpp"

namespace odeum::extended_test {
namespace {

using Verner98 = ExplicitRungeKutta<methods::verner98_digits, ExtendedProblem>;

/// y' = -y cos t, y = e^{-sin t}.
ExtendedProblem swing() {
  ExtendedProblem problem;
  problem.f = [](long double t, const long double* y, long double* f) {
    f[0] = -y[0] * std::cos(t);
  };
  problem.y0 = {1};
  return problem;
}

long double swing_error(std::uint64_t steps) {
  return std::abs(run_extended<Verner98>(swing(), 0, {1, 2}, steps).back() -
                  std::exp(-std::sin(2.0L)));
}

TEST(ExtendedPrecision, ConvergesBelowTheRoundingOfDouble) {
  if (std::numeric_limits<long double>::digits <= 53) GTEST_SKIP() << "long double is double here";
  const long double coarse = swing_error(20), fine = swing_error(28);
  EXPECT_LT(coarse, 1e-16L);
  // Order 9; on this problem the leading term is small and the next one shows. A coefficient that
  // were rounded to double would leave 1e-17.
  EXPECT_GT(std::log(coarse / fine) / std::log(1.4L), 8.75L);
  EXPECT_LT(fine, 1e-18L);
}

TEST(ExtendedPrecision, RecordsEveryStop) {
  const std::vector<long double> states = run_extended<Verner98>(swing(), 0, {1, 2}, 40);
  ASSERT_EQ(states.size(), 2U);
  EXPECT_NEAR(static_cast<double>(states[0]), std::exp(-std::sin(1.0)), 1e-14);
  EXPECT_NEAR(static_cast<double>(states[1]), std::exp(-std::sin(2.0)), 1e-14);
}

TEST(ExtendedPrecision, IsTheCasesOwnEquation) {
  int compared = 0;
  for (const Case& c : all_cases()) {
    if (!c.extended) continue;
    // Somewhere along the solution, where springs are stretched.
    std::vector<double> y(c.y0.size()), f(y.size());
    ASSERT_TRUE(c.truth.at(c.stops.front(), y.data())) << c.id;
    const std::vector<long double> y_extended(y.begin(), y.end());
    std::vector<long double> f_extended(y.size());
    c.problem.view.rhs(c.problem.view.problem, c.t0, y.data(), f.data());
    c.extended->rhs(c.t0, y_extended.data(), f_extended.data());
    EXPECT_EQ(c.extended->y0, std::vector<long double>(c.y0.begin(), c.y0.end())) << c.id;
    // It is not evaluated in double anywhere: changes below the rounding of double are seen.
    std::vector<long double> moved = y_extended, f_moved(y.size());
    for (long double& component : moved) component *= 1 + 0x1p-60L;
    c.extended->rhs(c.t0, moved.data(), f_moved.data());
    EXPECT_NE(f_moved, f_extended) << c.id;
    // Accelerations of up to 1e2 are sums of some twenty forces over 0.02 kg; where terms cancel, a
    // change of y by some roundings of double shows how much.
    for (long double& component : moved) component *= 1 + 0x1p-50L;
    c.extended->rhs(c.t0, moved.data(), f_moved.data());
    for (std::size_t i = 0; i < y.size(); ++i)
      EXPECT_NEAR(f[i], static_cast<double>(f_extended[i]),
                  1e-12 + static_cast<double>(std::abs(f_moved[i] - f_extended[i])))
          << c.id << " " << i;
    if (!c.extended->truth) continue;
    std::vector<long double> truth(y.size());
    ASSERT_TRUE(c.extended->truth(c.stops.front(), truth.data()));
    for (std::size_t i = 0; i < y.size(); ++i) EXPECT_EQ(y[i], static_cast<double>(truth[i]));
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

/// The order of a solver whose runs in double have none and in extended precision are `run`.
study::OrderRow order_of(const Case& c, const ExtendedRun& run) {
  Entrant entrant;
  entrant.info.order = 9;
  entrant.solve = [](const Request&) {
    Outcome outcome;
    outcome.status = Status::over_budget;  // no order in double
    outcome.counters.rhs_evaluations = 1;
    return outcome;
  };
  entrant.extended = run;
  const study::CaseMeasures measures{.gain = 1, .amplification = {}};
  return study::converge_pair({&c, &entrant, Mode::fixed}, measures, false).orders.front();
}

// It read "higher: order nan in extended precision".
TEST(ExtendedPrecision, AnOrderWithoutANumberIsNoVerdict) {
  const Case& c = known_case("lotka_volterra");
  ASSERT_TRUE(c.extended);
  using States = std::vector<long double>;
  const auto exact = [&](const ExtendedProblem& p, double, const std::vector<double>& stops,
                         std::uint64_t) {
    States states;
    for (const double stop : stops) {
      States y(p.size());
      p.truth(stop, y.data());
      states.insert(states.end(), y.begin(), y.end());
    }
    return states;
  };
  const auto failing = [&](const ExtendedProblem& p, double, const std::vector<double>& stops,
                           std::uint64_t) {
    return States(stops.size() * p.size(), std::numeric_limits<long double>::quiet_NaN());
  };
  for (const ExtendedRun& run : {ExtendedRun(exact), ExtendedRun(failing)}) {
    const study::OrderRow row = order_of(c, run);
    EXPECT_EQ(row.fit.verdict, judge::Verdict::over_budget) << row.fit.reason;
    EXPECT_EQ(row.fit.reason.find("nan"), std::string::npos) << row.fit.reason;
  }
}

}  // namespace
}  // namespace odeum::extended_test
