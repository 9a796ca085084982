// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/control/one_step.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "odeum/core/guarded.hpp"
#include "odeum/methods/cash_karp54.hpp"
#include "odeum/methods/heun.hpp"
#include "odeum/methods/midpoint.hpp"
#include "odeum/methods/rk4.hpp"
#include "odeum/proof/facts.hpp"
#include "odeum/solvers/enroll_method.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::adaptive_test {
namespace {

struct Clock {  // y' = 1
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double*, double* dydt) const { dydt[0] = 1; }
};

struct TrialStep {
  double t, h;
};

/// The adaptive loop over y' = 1 under a controller given by the test; records every trial.
template <class Control>
Outcome walk(const std::vector<double>& stops, double first_step, std::vector<TrialStep>& trials,
             Control&& control, double error = 0) {
  const Clock problem;
  const Request request = adaptive_request(1e-6, stops);
  Guard guard(1, request.budget);
  const Guarded<Clock> guarded(problem, guard);
  const auto trial = [&](double t, double h, const std::array<double, 1>& y,
                         std::array<double, 1>& y_new) {
    trials.push_back({t, h});
    y_new[0] = y[0] + h;
    return odeum::decide(control, h, error);
  };
  return run_adaptive(guarded, 0, std::array<double, 1>{0}, request, first_step, trial);
}

TEST(Adaptive, LandsExactlyOnEveryStopAndNeverLooksBeyond) {
  std::vector<TrialStep> trials;
  const std::vector<double> stops{0.5, 1, 1.7, 1.7 + 1e-9};
  const Outcome outcome = walk(stops, 0.3, trials, [](double, double) {
    return Decision{true, 0.3};
  });
  ASSERT_EQ(outcome.status, Status::ok);
  EXPECT_EQ(outcome.t, stops.back());
  EXPECT_EQ(outcome.counters.steps, trials.size());
  ASSERT_EQ(outcome.states.size(), stops.size());
  std::size_t next = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    EXPECT_LE(trials[i].t + trials[i].h, stops[next] + 1e-15);  // one rounding of the sum
    const double after = i + 1 < trials.size() ? trials[i + 1].t : outcome.t;
    if (after == stops[next]) {
      EXPECT_NEAR(outcome.states[next], stops[next], 1e-15);
      ++next;
    } else {
      EXPECT_EQ(trials[i].h, 0.3) << "only the step to a stop is cut short";
    }
  }
  EXPECT_EQ(next, stops.size());
}

TEST(Adaptive, RepeatsARejectedStepWithTheControllersNextOne) {
  std::vector<TrialStep> trials;
  const Outcome outcome = walk({1}, 0.8, trials, [](double h, double) {
    return h > 0.25 ? Decision{false, h / 2} : Decision{true, h};
  });
  EXPECT_EQ(outcome.status, Status::ok);
  EXPECT_EQ(outcome.counters.rejected_steps, 2U);
  EXPECT_EQ(outcome.counters.steps, 5U);
  EXPECT_EQ(trials[2].t, 0);
  EXPECT_EQ(trials[2].h, 0.2);
}

TEST(Adaptive, ShortensAStepThatFailsAndGivesUpTruthfully) {
  const auto always = [](double h, double) { return Decision{true, h}; };
  for (const double error : {std::nan(""), HUGE_VAL}) {
    std::vector<TrialStep> trials;
    const Outcome outcome = walk({1}, 0.5, trials, always, error);
    EXPECT_EQ(outcome.status, Status::step_too_small);
    EXPECT_NE(outcome.detail.find("t = 0"), std::string::npos) << outcome.detail;
    EXPECT_EQ(outcome.counters.steps, 0U);
    EXPECT_EQ(outcome.counters.rejected_steps, trials.size());
    EXPECT_EQ(outcome.t, 0);
    ASSERT_GT(trials.size(), 2U);
    EXPECT_EQ(trials[1].h, trials[0].h / 4);
  }
}

TEST(Adaptive, ErrorNormIsTheRootMeanSquareOfScaledErrors) {
  const std::array<double, 2> error{3e-6, -4e-6}, y{0, 1}, y_new{-2, 0.5};
  const ErrorScale scale(1e-6, y);  // 3e-6, 2e-6
  EXPECT_DOUBLE_EQ(scaled_error_norm(error, y, y_new, scale), std::sqrt((1 + 4) / 2.));
  for (const double bad : {HUGE_VAL, std::nan("")})
    EXPECT_FALSE(std::isfinite(scaled_error_norm(error, y, {0, bad}, scale)));
}

/// y' = y^2, y(0) = 1: a pole at t = 1.
struct Pole {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = y[0] * y[0]; }
  void jacobian(double, const double* y, double* j) const { j[0] = 2 * y[0]; }
};
struct Rest {  // y' = 0 from y = 0: nothing that determines a first step
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double*, double* dydt) const { dydt[0] = 0; }
  void jacobian(double, const double*, double* j) const { j[0] = 0; }
};

template <class M, Ode P>
Outcome solve(const Request& request, double y0) {
  return solve_own<M>(Contest<P>{.problem = std::make_shared<const P>(),
                                 .t0 = 0,
                                 .y0 = std::make_shared<const std::vector<double>>(1, y0),
                                 .scene = nullptr},
                      request);
}

template <class M>
void expect_to_stop_at_the_pole() {
  Request request = adaptive_request(1e-6, {0.5, 2});
  request.budget.evaluations = 10'000'000;
  const Outcome outcome = solve<M, Pole>(request, 1);
  EXPECT_TRUE(outcome.status == Status::step_too_small || outcome.status == Status::non_finite)
      << M::info.id << ": " << to_string(outcome.status);
  EXPECT_NE(outcome.detail, "");
  // The numerical pole lies off t = 1 by the error made while y is of size one: some tolerances at
  // order 4 and 5, tol^(2/3) = 1e-4 at order 2.
  EXPECT_NEAR(outcome.t, 1, 1e-4) << M::info.id;
  EXPECT_EQ(outcome.states.size(), 1U) << "the stop before the pole was reached, the other not";
}

TEST(Adaptive, StopsAtAPole) {
  expect_to_stop_at_the_pole<methods::cash_karp54>();
  expect_to_stop_at_the_pole<methods::rk4>();
  expect_to_stop_at_the_pole<methods::heun>();
}

TEST(Adaptive, PassesOverNothingAtAll) {
  for (const Outcome& outcome : {solve<methods::cash_karp54, Rest>(adaptive_request(1e-6, {9}), 0),
                                 solve<methods::rk4, Rest>(adaptive_request(1e-6, {9}), 0)}) {
    EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
    EXPECT_EQ(outcome.states, std::vector<double>{0});
    EXPECT_LE(outcome.counters.steps, 40U) << "steps grow from 1e-6 at least twofold each";
  }
}

/// Lotka and Volterra's equations, for the controllers.
struct Prey {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = (1.5 - y[1]) * y[0];
    dydt[1] = (y[0] - 3) * y[1];
  }
};

/// Records start and end of each step of the midpoint rule.
template <class P>
struct RecordingMidpoint : methods::midpoint::Stepper<P> {
  using Base = methods::midpoint::Stepper<P>;
  using Base::Base;
  struct Call {
    double t, h;
    State<P> before, after;
  };
  static inline std::vector<Call> calls;
  Status step(double t, double h, State<P>& y) {
    const State<P> before = y;
    const Status status = Base::step(t, h, y);
    calls.push_back({t, h, before, y});
    return status;
  }
};

TEST(StepDoubling, KeepsBothItsBounds) {
  using Recording = RecordingMidpoint<Guarded<Prey>>;
  const Prey problem;
  const Request request = adaptive_request(1e-6, {10});
  Guard guard(2, request.budget);
  const Guarded<Prey> guarded(problem, guard);
  Recording::calls.clear();
  StepDoubling<Recording, Guarded<Prey>> steps(guarded, request.tolerance, 2);
  const Outcome outcome = run_adaptive(guarded, 0, {1, 1}, request, 1e-3, steps);
  ASSERT_EQ(outcome.status, Status::ok);
  const auto& calls = Recording::calls;
  ASSERT_EQ(calls.size(), 3 * (outcome.counters.steps + outcome.counters.rejected_steps));
  int halved = 0, kept = 0, doubled = 0;
  for (std::size_t i = 0; i + 3 < calls.size(); i += 3) {
    const auto &whole = calls[i], &first = calls[i + 1], &second = calls[i + 2],
               &next = calls[i + 3];
    ASSERT_EQ(first.h, whole.h / 2);
    ASSERT_EQ(second.t, whole.t + whole.h / 2);
    std::array<double, 2> difference{};
    for (std::size_t n = 0; n < 2; ++n) difference[n] = whole.after[n] - second.after[n];
    const double norm = scaled_error_norm(difference, whole.before, second.after, {1e-6, {}});
    const bool ends = next.t + next.h >= 10;  // shortened to end at the stop
    if (norm > 1) {
      EXPECT_EQ(next.t, whole.t) << "repeated";
      EXPECT_EQ(next.h, whole.h / 2);
      ++halved;
    } else {
      EXPECT_GT(next.t, whole.t);
      EXPECT_EQ(next.before, second.after) << "the two half steps are kept, as they are";
      if (ends) continue;
      const bool below = norm < 1. / 16;  // half of 2^-(2+1)
      EXPECT_EQ(next.h, below ? 2 * whole.h : whole.h);
      ++(below ? doubled : kept);
    }
  }
  EXPECT_GT(halved, 5);
  EXPECT_GT(doubled, 5);
  EXPECT_GT(kept, 50);
}

TEST(EmbeddedPairs, EstimateFallsWithThePowerOfTheLowerOrder) {
  FunctionProblem problem;
  problem.unknowns = 2;
  problem.f = [](double t, const double* y, double* dydt) { Prey{}.rhs(t, y, dydt); };
  problem.f_y = [](double, const double* y, double* j) {
    const double rows[] = {1.5 - y[1], -y[0], y[1], y[0] - 3};
    std::copy_n(rows, 4, j);
  };
  problem.f_t = [](double, const double*, double* dfdt) { dfdt[0] = dfdt[1] = 0; };
  int checked = 0;
  for (const proof::MethodFacts& method : proof::all_method_facts()) {
    if (method.info.order_embedded == 0 || !method.on_problem) continue;
    const auto stepper = method.on_problem(problem);
    const auto estimate = [&](double h) {
      std::vector<double> y{1, 1}, error;
      EXPECT_EQ(stepper->step(0, h, y, &error), Status::ok);
      return std::hypot(error[0], error[1]);
    };
    const int power = std::min(method.info.order, method.info.order_embedded) + 1;
    // Below 1e-11 higher powers of h (0.2) and rounding change the slope by less than 0.4.
    double h = 0.5;
    while (estimate(h) > 1e-11) h *= 0.9;
    EXPECT_NEAR(std::log2(estimate(h) / estimate(h / 2)), power, 0.4) << method.info.id;
    ++checked;
  }
  EXPECT_GE(checked, 1);
}

/// The power of h, less one, that a method's error estimate has.
int lower_order(const SolverInfo& info) {
  for (const proof::MethodFacts& method : proof::all_method_facts()) {
    const MethodInfo& own = method.info;
    if (info.method != own.id) continue;
    if (own.order_embedded != 0) return std::min(own.order, own.order_embedded);
    return own.adaptive_order ? own.order - 1 : own.order;  // the order varies with the tolerance
  }
  return 0;
}

TEST(Adaptive, ErrorFollowsTheTolerance) {
  const Case& c = find_case("lotka_volterra");
  int checked = 0;
  for (const Entrant& entrant : c.entrants) {
    if (entrant.info.library != "odeum" || !entrant.info.adaptive || !entrant.solve) continue;
    SCOPED_TRACE(entrant.info.id());
    const auto error_at = [&](double tolerance) {
      const Outcome outcome = entrant.solve(adaptive_request(tolerance, c.stops));
      EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
      EXPECT_EQ(outcome.t, c.stops.back());
      double error = 0;
      for (std::size_t stop = 0; stop < c.stops.size(); ++stop) {
        std::array<double, 2> exact{};
        c.truth.at(c.stops[stop], exact.data());
        const auto y = state_at(outcome, stop, 2);
        error = std::max(error, std::hypot(y[0] - exact[0], y[1] - exact[1]));
      }
      return error;
    };
    const double slope = std::log10(error_at(1e-4) / error_at(1e-8)) / 4;
    // A step commits an error of tol and is h = tol^(1/(q+1)) long, with q the lower order of the
    // pair or, under step doubling, the method's own; over the orbit h^p remains. Steps restricted
    // to powers of two make either end uncertain by a factor of two: 2 log10(2) / 4. From order 6
    // on a run takes ten to thirty steps, and the shortened last one adds as much. So do
    // controllers with a memory and estimates of varying order.
    const double p = std::isnan(entrant.info.order) ? 1 : entrant.info.order;
    const int lower = lower_order(entrant.info);  // 0: varies with the tolerance
    const double theory = lower > 0 ? p / (lower + 1) : 1;
    const bool plain = entrant.info.controller == "step doubling" && p < 6;
    EXPECT_NEAR(slope, theory, plain ? 0.15 : 0.4);
    ++checked;
  }
  EXPECT_GE(checked, 8);
}

}  // namespace
}  // namespace odeum::tests::adaptive_test
