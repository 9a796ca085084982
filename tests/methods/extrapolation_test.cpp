// SPDX-License-Identifier: BSD-3-Clause
// Extrapolation, Taylor series, the exact propagator.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "odeum/control/run_method.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/linear/matrix_exponential.hpp"
#include "odeum/methods/exponential_propagator.hpp"
#include "odeum/methods/gragg_bulirsch_stoer.hpp"
#include "odeum/methods/taylor.hpp"
#include "problems/kepler.hpp"
#include "support/order.hpp"

namespace odeum::tests::extrapolation_test {
namespace {

struct KeplerSeries : Kepler {
  void taylor(double t, const double* y, int order, double* c) const {
    cases::Kepler{}.taylor(t, y, order, c);
  }
};

/// A damped oscillator, as a series and as a matrix.
struct LinearSystem {
  static constexpr std::size_t dimension = 2;
  static constexpr double damping = 0.2, stiffness = 1.01;  // roots -0.1 +- i
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = y[1];
    dydt[1] = -stiffness * y[0] - damping * y[1];
  }
  void taylor(double, const double* y, int order, double* c) const {
    c[0] = y[0];
    c[1] = y[1];
    for (int k = 0; k < order; ++k) {
      rhs(0, c + 2 * k, c + 2 * k + 2);
      c[2 * k + 2] /= k + 1;
      c[2 * k + 3] /= k + 1;
    }
  }
  void linear_matrix(double* a) const {
    a[0] = 0;
    a[1] = 1;
    a[2] = -stiffness;
    a[3] = -damping;
  }
  static State<LinearSystem> exact(double t) {
    const double decay = std::exp(-0.1 * t);
    return {decay * std::cos(t), -decay * (0.1 * std::cos(t) + std::sin(t))};
  }
};

template <class M, class P>
Outcome integrate(double tolerance, std::vector<double> stops, Budget budget = {}) {
  const P problem;
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = tolerance;
  request.stops = std::move(stops);
  request.budget = budget;
  Guard guard(P::dimension, request.budget);
  const Guarded<P> guarded(problem, guard);
  Outcome outcome = run_method<M>(guarded, 0, P::exact(0), request);
  guard.conclude(request, outcome);
  return outcome;
}

template <class P>
double error_at(const Outcome& outcome, std::size_t stop, double t) {
  State<P> y = P::exact(t);
  for (std::size_t i = 0; i < P::dimension; ++i) y[i] -= outcome.states[stop * P::dimension + i];
  return distance(y, State<P>{});
}

template <class M, class P>
void expect_tolerance_to_be_followed(double largest_factor) {
  const std::vector<double> stops{0.5, 3, 10};
  double last = std::numeric_limits<double>::infinity();
  for (const double tolerance : {1e-4, 1e-7, 1e-10}) {
    const Outcome outcome = integrate<M, P>(tolerance, stops);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    EXPECT_EQ(outcome.t, 10);
    ASSERT_EQ(outcome.states.size(), 3 * P::dimension);
    const double error = error_at<P>(outcome, 2, 10);
    EXPECT_LT(error, largest_factor * tolerance) << tolerance;
    EXPECT_LT(error, last) << tolerance;
    last = error;
  }
}

// --- Gragg, Bulirsch, Stoer ---

using methods::gragg_bulirsch_stoer;

TEST(GraggBulirschStoer, HasOrderEightAtAFixedStep) {
  // The next even power of h shows as well in a halving of steps that are not tiny.
  EXPECT_NEAR(measured_order<gragg_bulirsch_stoer::Stepper>(Kepler{}, 0.2, 2.3, 8), 8, 0.45);
  EXPECT_NEAR(measured_order<gragg_bulirsch_stoer::Stepper>(Driven{}, 0.2, 1.7, 8), 8, 0.45);
}

TEST(GraggBulirschStoer, TableHasTwoOrdersMoreALine) {
  // y' = z y at h = 1: line j agrees with e^z to order 2 (j + 1), so the error at z / 2 is
  // smaller by 2^(2 j + 3).
  const auto slope = [](auto stability) {
    const double z = 0.5;
    const auto error = [&](double x) { return std::abs(stability(x) - std::exp(x)); };
    return std::log2(error(z) / error(z / 2));
  };
  using Complex = std::complex<double>;
  EXPECT_NEAR(slope([](Complex z) { return extrapolated_midpoint_stability<1>(z); }), 3, 0.3);
  EXPECT_NEAR(slope([](Complex z) { return extrapolated_midpoint_stability<2>(z); }), 5, 0.3);
  EXPECT_NEAR(slope([](Complex z) { return extrapolated_midpoint_stability<3>(z); }), 7, 0.3);
}

struct Dahlquist {  // y' = z y, real and imaginary part
  static constexpr std::size_t dimension = 2;
  std::complex<double> z;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = z.real() * y[0] - z.imag() * y[1];
    dydt[1] = z.imag() * y[0] + z.real() * y[1];
  }
};

TEST(GraggBulirschStoer, StabilityFunctionIsThatOfTheRunningCode) {
  for (const std::complex<double> z : {std::complex<double>{-3, 0}, {0.4, 2.5}, {-5, -3}}) {
    const Dahlquist problem{z};
    gragg_bulirsch_stoer::Stepper<Dahlquist> stepper(problem);
    State<Dahlquist> y{1, 0};
    stepper.step(0, 1, y);
    // Extrapolation weights of a few units, some hundred roundings of numbers of up to |z|^8 / 8!.
    EXPECT_NEAR(std::hypot(y[0], y[1]), gragg_bulirsch_stoer::amplification(z.real(), z.imag()),
                1e-12);
  }
}

TEST(GraggBulirschStoer, FollowsTheTolerance) {
  // Errors of steps add up over the orbit: some hundred tolerances at most.
  expect_tolerance_to_be_followed<gragg_bulirsch_stoer, Kepler>(300);
  expect_tolerance_to_be_followed<gragg_bulirsch_stoer, Driven>(300);
}

TEST(GraggBulirschStoer, TakesAHigherOrderForASmallerTolerance) {
  const auto evaluations_a_step = [](double tolerance) {
    const Outcome o = integrate<gragg_bulirsch_stoer, Kepler>(tolerance, {60});
    EXPECT_EQ(o.status, Status::ok) << o.detail;
    EXPECT_LT(o.counters.rejected_steps, o.counters.steps) << tolerance;
    return static_cast<double>(o.counters.rhs_evaluations) / static_cast<double>(o.counters.steps);
  };
  const double low = evaluations_a_step(1e-3), high = evaluations_a_step(1e-11);
  EXPECT_GT(high, 1.5 * low);
}

TEST(GraggBulirschStoer, StopsAtItsBudget) {
  const Outcome o = integrate<gragg_bulirsch_stoer, Kepler>(1e-8, {1000}, {.evaluations = 500});
  EXPECT_EQ(o.status, Status::over_budget);
  EXPECT_EQ(o.counters.rhs_evaluations, 500U);
  EXPECT_GT(o.t, 0);
  EXPECT_LT(o.t, 100);
}

struct Pole {  // y' = y^2, y = 1 / (1 - t)
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = y[0] * y[0]; }
  void taylor(double, const double* y, int order, double* c) const {
    c[0] = y[0];
    for (int k = 1; k <= order; ++k) c[k] = c[k - 1] * y[0];
  }
  static State<Pole> exact(double t) { return {1 / (1 - t)}; }
};

template <class M>
void expect_to_stop_at_the_pole() {
  const Outcome o = integrate<M, Pole>(1e-8, {0.5, 2});
  EXPECT_TRUE(o.status == Status::step_too_small || o.status == Status::non_finite)
      << to_string(o.status);
  EXPECT_NEAR(o.t, 1, 1e-5);  // the numerical pole is off by the error made, some tolerances
  EXPECT_EQ(o.states.size(), 1U);
  EXPECT_LT(error_at<Pole>(o, 0, 0.5), 1e-6);
}

TEST(OwnControllers, StopAtAPole) {
  expect_to_stop_at_the_pole<gragg_bulirsch_stoer>();
  expect_to_stop_at_the_pole<methods::taylor>();
}

// --- Taylor ---

using methods::taylor;

TEST(Taylor, HasItsOrderAtAFixedStep) {
  const KeplerSeries problem;
  // Order 12 meets rounding within two halvings from 1e-9; the first one shows it, the next power
  // of h included. measured_order would reach rounding.
  const auto error = [&](int steps) {
    return error_of_run<taylor::Stepper>(problem, 0.2, 2.3, steps);
  };
  int steps = 4;
  while (error(steps) > 1e-8) ++steps;
  EXPECT_NEAR(std::log2(error(steps) / error(2 * steps)), 12, 0.8);
}

TEST(Taylor, FollowsTheTolerance) {
  expect_tolerance_to_be_followed<taylor, KeplerSeries>(300);
  expect_tolerance_to_be_followed<taylor, LinearSystem>(300);
}

TEST(Taylor, TakesTheOrderThatTheToleranceAsksFor) {
  // ceil(1 - ln(tol) / 2) coefficients a step, each counted as an evaluation, and one evaluation
  // more where a component changes its sign.
  for (const auto& [tolerance, order] : {std::pair{1e-6, 8U}, {1e-12, 15U}}) {
    const Outcome o = integrate<taylor, KeplerSeries>(tolerance, {10});
    EXPECT_GE(o.counters.rhs_evaluations, order * o.counters.steps);
    EXPECT_LE(o.counters.rhs_evaluations, (order + 1) * o.counters.steps);
  }
}

struct Fall {  // q'' = -1: the series ends
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = y[1];
    dydt[1] = -1;
  }
  void taylor(double, const double* y, int order, double* c) const {
    std::fill_n(c, 2 * (order + 1), 0.0);
    c[0] = y[0];
    c[1] = c[2] = y[1];
    c[3] = -1;
    c[4] = -0.5;
  }
  static State<Fall> exact(double t) { return {2 * t - t * t / 2, 2 - t}; }
};

TEST(Taylor, PassesOverAPolynomialInOneStep) {
  const Outcome o = integrate<taylor, Fall>(1e-8, {3, 7});
  EXPECT_EQ(o.status, Status::ok);
  EXPECT_EQ(o.counters.steps, 2U);
  EXPECT_LT(error_at<Fall>(o, 1, 7), 1e-14);  // a few roundings of numbers of size ten
}

TEST(Taylor, StopsAtItsBudget) {
  const Outcome o = integrate<taylor, KeplerSeries>(1e-8, {1000}, {.evaluations = 500});
  EXPECT_EQ(o.status, Status::over_budget);
  EXPECT_EQ(o.counters.rhs_evaluations, 500U);
}

// --- the exact propagator ---

using methods::exponential_propagator;

TEST(ExponentialPropagator, IsExactAtAnyStep) {
  for (const int steps : {1, 7, 200})
    // A rounding or two of size one per step, damped by the solution.
    EXPECT_LT(error_of_run<exponential_propagator::Stepper>(LinearSystem{}, 0, 30, steps), 1e-14)
        << steps;
  const Outcome o = integrate<exponential_propagator, LinearSystem>(1e-3, {0.5, 20});
  EXPECT_EQ(o.status, Status::ok);
  EXPECT_EQ(o.counters.rhs_evaluations, 2U);  // one a step length, for b
  EXPECT_LT(error_at<LinearSystem>(o, 1, 20), 1e-14);
}

TEST(MatrixExponential, OfMatricesWhoseExponentialIsKnown) {
  using linear::matrix_exponential;
  const double w = 40;  // needs squaring
  const auto rotation = matrix_exponential({0, -w, w, 0}, 2);
  // Three squarings, each doubles an error of some roundings of |A| = 5: 1e-13 is ten times that.
  EXPECT_NEAR(rotation[0], std::cos(w), 1e-13);
  EXPECT_NEAR(rotation[1], -std::sin(w), 1e-13);
  EXPECT_NEAR(rotation[2], std::sin(w), 1e-13);
  const auto nilpotent = matrix_exponential({0, 1, 2, 0, 0, 3, 0, 0, 0}, 3);
  const std::vector<double> expected{1, 1, 2 + 1.5, 0, 1, 3, 0, 0, 1};
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(nilpotent[i], expected[i], 1e-14);
  const auto scalar = matrix_exponential({-700}, 1);
  EXPECT_NEAR(scalar[0] / std::exp(-700), 1, 1e-12);  // 2^7 squarings' worth of roundings
  EXPECT_TRUE(matrix_exponential({800}, 1).empty()) << "overflows";
  EXPECT_TRUE(matrix_exponential({std::nan("")}, 1).empty());
}

}  // namespace
}  // namespace odeum::tests::extrapolation_test
