// SPDX-License-Identifier: BSD-3-Clause
// The explicit Runge-Kutta methods: orders, first-same-as-last, controllers, dense output.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "odeum/control/run_method.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/kernel/dense_output.hpp"
#include "odeum_methods.hpp"
#include "support/order.hpp"

namespace odeum::tests::explicit_library_test {
namespace {

template <class Visit>
void for_each_explicit(Visit&& visit) {
  methods::All::for_each([&]<class M>() {
    if constexpr (requires { M::tableau.is_explicit(); })
      if constexpr (M::tableau.is_explicit()) visit.template operator()<M>();
  });
}

TEST(ExplicitLibrary, HasTheOrdersThatItClaims) {
  int checked = 0;
  for_each_explicit([&]<class M>() {
    const int p = M::info.order;
    // At steps that are not tiny the next power of h contributes to the slope of a halving. Order 9
    // reaches 1e-9 in a few steps of half a unit: it is distinguished from 8 here, from 10 by the
    // order conditions.
    const double band = p < 9 ? 0.45 : 1.4;
    const double centre = p < 9 ? p : p + 0.9;
    EXPECT_NEAR(measured_order<M::template Stepper>(Kepler{}, 0.2, 2.3, p), centre, band)
        << M::info.id;
    EXPECT_NEAR(measured_order<M::template Stepper>(Driven{}, 0.2, 1.7, p), centre, band)
        << M::info.id;
    ++checked;
  });
  EXPECT_GE(checked, 20);
}

TEST(ExplicitLibrary, BothEstimatesOfDormandPrince853Count) {
  constexpr const auto& t = methods::dormand_prince853_tableau;
  constexpr const auto& third = methods::dormand_prince853_third_order;
  EXPECT_EQ(order_fault(t, t.b_hat, 5).order, 0);
  EXPECT_EQ(order_fault(t, third, 3).order, 0);
  methods::dormand_prince853::Stepper<Kepler> stepper{Kepler{}};
  ExplicitRungeKutta<methods::dormand_prince853_tableau, Kepler> plain{Kepler{}};
  const double h = 0.3;
  State<Kepler> y = Kepler::exact(0), error{}, y_plain = y, five{};
  stepper.step(0, h, y, error);
  plain.step(0, h, y_plain, five);
  EXPECT_EQ(y, y_plain);
  double ratio = error[0] / five[0];
  EXPECT_GT(ratio, 0);
  EXPECT_LT(ratio, 1);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_DOUBLE_EQ(error[i], ratio * five[i]);
}

// --- first same as last ---

/// Kepler's problem with a count of evaluations.
struct Counted : Kepler {
  int* count;
  void rhs(double t, const double* y, double* dydt) const {
    ++*count;
    Kepler::rhs(t, y, dydt);
  }
};

template <class M>
void expect_reuse_to_change_nothing() {
  int fresh_count = 0, reuse_count = 0;
  const Counted fresh_problem{{}, &fresh_count}, reuse_problem{{}, &reuse_count};
  typename M::template Stepper<Counted> fresh(fresh_problem), reuse(reuse_problem);
  State<Kepler> y = Kepler::exact(0), y_fresh = y, y_reuse = y, error{}, error_reuse{};
  double t = 0;
  // Varying steps; every third one is rejected and repeated with half its length.
  for (int i = 0; i < 12; ++i) {
    for (double h : {0.05 + 0.01 * (i % 4), 0.025 + 0.005 * (i % 4)}) {
      y_fresh = y_reuse = y;
      fresh.step(t, h, y_fresh, error);
      reuse.step(t, h, y_reuse, error_reuse);
      // Bit for bit: f is a function of (t, y), and the last stage's argument is the new state,
      // summed in the order of the row of weights.
      ASSERT_EQ(y_fresh, y_reuse) << M::info.id << " step " << i;
      ASSERT_EQ(error, error_reuse) << M::info.id << " step " << i;
      if (i % 3 == 2 && h >= 0.05) {
        reuse.repeat();
        continue;
      }
      reuse.advance();
      y = y_fresh;
      t += h;
      break;
    }
  }
  const int trials = 12 + 4, stages = static_cast<int>(M::tableau.stages);
  EXPECT_EQ(fresh_count, trials * stages) << M::info.id;
  const bool last_is_first = M::tableau.first_same_as_last();
  EXPECT_EQ(reuse_count, trials * stages - (last_is_first ? trials - 1 : 4)) << M::info.id;
}

TEST(FirstSameAsLast, SavesAnEvaluationAStepAndChangesNothing) {
  expect_reuse_to_change_nothing<methods::bogacki_shampine32>();
  expect_reuse_to_change_nothing<methods::dormand_prince54>();
  expect_reuse_to_change_nothing<methods::tsitouras54>();
  expect_reuse_to_change_nothing<methods::verner65>();
  expect_reuse_to_change_nothing<methods::cash_karp54>();  // not first same as last: only repeated
                                                           // steps save
  static_assert(methods::dormand_prince54_tableau.first_same_as_last());
  static_assert(methods::tsitouras54_tableau.first_same_as_last());
  static_assert(methods::bogacki_shampine32_tableau.first_same_as_last());
  static_assert(methods::verner65_tableau.first_same_as_last());
}

// --- control ---

template <class M>
Counters adaptive_run(double tolerance, double& error) {
  const Kepler problem;
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = tolerance;
  request.stops = {1, 7.5, 20};
  Guard guard(4, request.budget);
  const Guarded<Kepler> guarded(problem, guard);
  Outcome outcome = run_method<M>(guarded, 0, Kepler::exact(0), request);
  guard.conclude(request, outcome);
  EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
  State<Kepler> end{};
  for (std::size_t i = 0; i < 4; ++i) end[i] = outcome.states[8 + i];
  error = distance(end, Kepler::exact(20));
  return outcome.counters;
}

TEST(StepControl, EveryPolicyFollowsTheTolerance) {
  const auto check = [&]<class M>() {
    double coarse = 0, fine = 0;
    const Counters counters = adaptive_run<M>(1e-7, coarse);
    adaptive_run<M>(1e-11, fine);
    // Error per step of the tolerance, with steps that go as tol^(1/5): 4 decades of tolerance give
    // 4 of error; one for the constants, which differ along the orbit.
    EXPECT_NEAR(std::log10(coarse / fine), 4, 1) << M::info.id;
    // Every trial costs 6 evaluations of 7; 2 more for the first length, one for the first stage.
    EXPECT_EQ(counters.rhs_evaluations, 3 + 6 * (counters.steps + counters.rejected_steps))
        << M::info.id;
  };
  check.operator()<methods::dormand_prince54>();
  check.operator()<methods::dormand_prince54_pi>();
  check.operator()<methods::dormand_prince54_dead_band>();
}

TEST(StepControl, AQuickPowerIsAPower) {
  for (const double p : {-1.0, -0.2, -1. / 9, 0.14, 0.8, 2.0})
    for (double x = 1e-30; x < 1e30; x *= 1.37)
      EXPECT_NEAR(quick_power(x, p) / std::pow(x, p), 1, 1e-5) << x << "^" << p;
  // Interpolation of x^p on [1, 2] by degree 4: 8.1e-5 for the root, 9e-6 for the tenth root.
  for (const auto& [p, accuracy] :
       {std::pair{-0.5, 1e-4}, {-0.35, 5e-5}, {-0.1, 1e-5}, {-0.05, 5e-6}}) {
    const FixedPower fixed(p);
    for (double x = 1e-20; x < 1e19; x *= 1.37)
      EXPECT_NEAR(fixed(x) / std::pow(x, p), 1, accuracy) << x << "^" << p;
    for (const double x : {0.0, 1e-300, 1e300})
      EXPECT_TRUE(fixed(x) > 0 && std::isfinite(fixed(x))) << x << "^" << p;
  }
  // For extreme errors it saturates, and stays positive and finite.
  EXPECT_GT(quick_power(1e300, -4), 0);
  EXPECT_LT(quick_power(1e-300, -4), std::numeric_limits<double>::infinity());
  EXPECT_EQ(power(3, 0), 1);
  EXPECT_EQ(power(3, 4), 81);
}

TEST(StepControl, PoliciesAreWhatTheySay) {
  constexpr double quick = 2e-5;  // the accuracy of FixedPower for such exponents
  const IntegralControl integral(4);
  EXPECT_FALSE(integral(1, 1.01 * 1.01).accept);
  EXPECT_NEAR(integral(2, std::pow(1.0 / 32, 2)).next_step, 2 * 0.9 * 2,
              4 * quick);  // 32^(1/5) = 2
  EXPECT_DOUBLE_EQ(integral(1, 1e18).next_step, 0.2);
  EXPECT_DOUBLE_EQ(integral(1, 0).next_step, 5);

  const DeadBandControl band(4);
  for (const double error : {0.4, 0.7, 1.0}) {
    EXPECT_TRUE(band(3, error * error).accept);
    EXPECT_EQ(band(3, error * error).next_step, 3);
  }
  for (const double error : {0.39, 1.01, 1e-7})
    EXPECT_EQ(band(3, error * error).next_step, integral(3, error * error).next_step);
  EXPECT_FALSE(band(3, 1.01 * 1.01).accept);

  ProportionalIntegralControl pi(4);
  EXPECT_NEAR(pi(1, std::pow(32, -2)).next_step, 0.9 * std::pow(32, 0.14), 2 * quick);
  // The same error again: the integral part remains, 0.3 / 5.
  EXPECT_NEAR(pi(1, std::pow(32, -2)).next_step, 0.9 * std::pow(32, 0.06), 2 * quick);
  const Decision rejected = pi(1, 32 * 32);
  EXPECT_FALSE(rejected.accept);
  EXPECT_NEAR(rejected.next_step, 0.9 / 2, quick);
  EXPECT_EQ(pi(1, 1e-18).next_step, 1) << "no growth after a rejected step";
  EXPECT_GT(pi(1, 1e-18).next_step, 1);
  // Gustafsson's factor: 0.9 (h / h_last) (err_last / err^2)^(1/k), never above the integral one.
  PredictiveControl predictive(4);
  EXPECT_NEAR(predictive(1, std::pow(32, -2)).next_step, 0.9 * 2, 2 * quick);
  EXPECT_NEAR(predictive(2, std::pow(243, -2)).next_step, 2 * 0.9 * 3, 6 * quick);
  EXPECT_NEAR(predictive(2, std::pow(32, -2)).next_step, 2 * 0.9 * std::pow(0.01 * 1024, 0.2),
              6 * quick)
      << "no last error counts as less than 0.01";
}

// --- dense output ---

template <class M, class P>
double interpolation_error(const P& problem, double t, double h) {
  typename M::template Stepper<P> stepper(problem);
  const State<P> y0 = P::exact(t);
  State<P> y1 = y0, error{}, f1{}, y{};
  stepper.step(t, h, y1, error);
  problem.rhs(t + h, y1.data(), f1.data());
  double worst = 0;
  for (const double theta : {0.15, 0.35, 0.5, 0.8}) {
    interpolate<M>(stepper, theta, h, y0, y1, f1, y);
    worst = std::max(worst, distance(y, P::exact(t + theta * h)));
  }
  for (const double theta : {0.0, 1.0}) {
    interpolate<M>(stepper, theta, h, y0, y1, f1, y);
    EXPECT_LE(distance(y, theta == 0 ? y0 : y1), 4e-16);  // a rounding or two of size one
  }
  return worst;
}

template <class M>
void expect_interpolant_of_order(int order) {
  // From h where the error is near 1e-6 down by four; the error of one step goes as
  // h^(order + 1), the next power of h adds about h to the slope.
  const auto slope = [](const auto& problem, double t) {
    const double h = 0.2;
    return std::log2(interpolation_error<M>(problem, t, h) /
                     interpolation_error<M>(problem, t, h / 4)) /
           2;
  };
  EXPECT_NEAR(slope(Kepler{}, 0.7), order + 1, 0.4) << M::info.id;
  EXPECT_NEAR(slope(Driven{}, 0.9), order + 1, 0.4) << M::info.id;
}

TEST(DenseOutput, HasTheOrderOfItsInterpolant) {
  expect_interpolant_of_order<methods::dormand_prince54>(4);
  expect_interpolant_of_order<methods::tsitouras54>(4);
  expect_interpolant_of_order<methods::cash_karp54>(3);
  expect_interpolant_of_order<methods::bogacki_shampine32>(3);
  expect_interpolant_of_order<methods::verner65>(3);
}

TEST(DenseOutput, ARowThatIsWrongIsSeen) {
  constexpr std::array<double, 7> none{}, wrong = [] {
    auto row = methods::dormand_prince54_dense_row;
    row[3] += 1e-6;
    return row;
  }();
  static_assert(interpolation_fault(methods::dormand_prince54_tableau, none).order == 4);
  static_assert(interpolation_fault(methods::dormand_prince54_tableau, wrong).order != 0);
  static_assert(
      interpolation_fault(methods::tsitouras54_tableau, methods::dormand_prince54_dense_row)
          .order != 0);
}

}  // namespace
}  // namespace odeum::tests::explicit_library_test
