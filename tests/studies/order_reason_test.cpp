// SPDX-License-Identifier: BSD-3-Clause
// What a verdict on an order says beyond its fit, and the cases that have to show one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "odeum/cases/set_problem.hpp"
#include "odeum/judge/amplification.hpp"
#include "odeum/studies/convergence/pair_runs.hpp"
#include "odeum/studies/convergence/settings.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::order_reason_test {
namespace {

judge::OrderFit order_of(const Case& c, const std::string& solver) {
  const study::CaseMeasures measures{.gain = judge::perturbation_gain(c), .amplification = {}};
  const Entrant& entrant = find_entrant(c, solver);
  return study::converge_pair({&c, &entrant, Mode::fixed}, measures, false).orders.front().fit;
}

/// y' = y (1 - y).
struct Growth {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* f) const { f[0] = y[0] * (1 - y[0]); }
};
struct GrowthWithJacobian : Growth {
  void jacobian(double, const double* y, double* j) const { j[0] = 1 - 2 * y[0]; }
};

template <class P>
Case growth(const P& problem) {
  Case c;
  c.id = "growth";
  c.nature.smooth = true;
  c.y0 = {0.1};
  c.stops = {2, 4};
  c.settings.steps_multiple = 2;
  c.truth.at = [](double t, double* y) {
    y[0] = 1 / (1 + 9 * std::exp(-t));
    return true;
  };
  cases::set_problem(c, problem);
  return c;
}

// The error of a Jacobian by differences, 1e-8, is one of a Rosenbrock method, of first order.
TEST(OrderReason, NamesADifferencedJacobian) {
  const char* const words = "the Jacobian is taken by differences";
  const judge::OrderFit differenced = order_of(growth(Growth()), "odeum/rodas4");
  EXPECT_EQ(differenced.verdict, judge::Verdict::lower) << differenced.reason;
  EXPECT_NEAR(differenced.order, 1, 0.15) << differenced.reason;
  EXPECT_NE(differenced.reason.find(words), std::string::npos) << differenced.reason;
  const judge::OrderFit exact = order_of(growth(GrowthWithJacobian()), "odeum/rodas4");
  EXPECT_EQ(exact.verdict, judge::Verdict::confirmed) << exact.reason;
  EXPECT_EQ(exact.reason.find(words), std::string::npos) << exact.reason;
  // A method that iterates pays in iterations, not in its error.
  EXPECT_EQ(order_of(growth(Growth()), "odeum/sdirk4").verdict, judge::Verdict::confirmed);
}

// Thousands of springs become taut or slack: a step across one errs by O(h^2), whatever the method.
TEST(OrderReason, NoMethodHasAnOrderAboveTwoAtKinks) {
  const Case& c = find_case("cloth11_tension_only");
  for (const char* solver : {"odeum/velocity_verlet", "odeum/implicit_midpoint"})
    EXPECT_EQ(order_of(c, solver).verdict, judge::Verdict::confirmed)
        << solver << ' ' << order_of(c, solver).reason;
  const judge::OrderFit rk4 = order_of(c, "odeum/rk4");
  EXPECT_EQ(rk4.verdict, judge::Verdict::not_applicable);
  EXPECT_NE(rk4.reason.find("kinks"), std::string::npos) << rk4.reason;
}

TEST(OrderReason, StiffSpringsShowTheOrdersOfImplicitMethodsToo) {
  const Case& c = find_case("cloth11_two_way_k1e3");
  EXPECT_EQ(study::convergence_stops(c), std::vector<double>{c.stops.front()});
  for (const char* solver : {"odeum/rk4", "odeum/implicit_midpoint"}) {
    const judge::OrderFit fit = order_of(c, solver);
    EXPECT_EQ(fit.verdict, judge::Verdict::confirmed) << solver << ' ' << fit.reason;
  }
}

// A dense matrix of 726 unknowns is refused before the first evaluation: no budget helps, and there
// is no order to judge.
TEST(OrderReason, ARefusedMatrixDoesNotApply) {
  const Case& c = find_case("cloth11_two_way_k1e3");
  if (!c.entrants.find("gsl/rk4imp")) GTEST_SKIP() << "without GSL";
  const judge::OrderFit fit = order_of(c, "gsl/rk4imp");
  EXPECT_EQ(fit.verdict, judge::Verdict::not_applicable);
  EXPECT_NE(fit.reason.find("needs a dense Jacobian of 726 unknowns"), std::string::npos)
      << fit.reason;
}

// Three tolerances are too few; what lies between them is cheaper than the next one.
TEST(OrderReason, AnOpenOrderToAToleranceGetsTolerancesBetween) {
  Case c = growth(Growth());
  c.settings.evaluation_budget = 1'000;
  const study::CaseMeasures measures{.gain = judge::perturbation_gain(c),
                                     .amplification = judge::measure_amplification(c, c.stops)};
  const Entrant& entrant = find_entrant(c, "odeum/explicit_euler");
  const auto result = study::converge_pair({&c, &entrant, Mode::adaptive}, measures, false);
  EXPECT_EQ(result.orders.front().fit.verdict, judge::Verdict::confirmed)
      << result.orders.front().fit.reason;
  std::vector<double> tolerances;
  for (const study::ConvergenceRow& row : result.rows) tolerances.push_back(row.setting);
  EXPECT_TRUE(std::is_sorted(tolerances.rbegin(), tolerances.rend())) << "from loose to tight";
  EXPECT_NE(std::find_if(tolerances.begin(), tolerances.end(),
                         [](double t) { return std::abs(t / 3.2e-4 - 1) < 1e-9; }),
            tolerances.end())
      << "halfway between 1e-3 and 1e-4, in two digits";
  const auto quick = study::converge_pair({&c, &entrant, Mode::adaptive}, measures, true);
  EXPECT_LT(quick.rows.size(), result.rows.size()) << "a quick study adds none";
}

}  // namespace
}  // namespace odeum::tests::order_reason_test
