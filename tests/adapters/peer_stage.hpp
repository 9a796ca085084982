// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "odeum/solvers/solver.hpp"

/// A test problem with injectable faults, and the checks of every solver enrolled on it.
namespace odeum::test {

/// u' = v + 2 (sin t - u) v,  v' = -u + 1.5 (cos t - v) u from (0, 1), whose solution is
/// (sin t, cos t): coupled, nonlinear and non-autonomous, so that a wrong node or a missing df/dt
/// shows. With `pole`, u' = u^2 from u = 1 instead, which ends at t = 1.
struct Circle {
  static constexpr std::size_t dimension = 2;
  bool pole = false;
  double nan_after = std::numeric_limits<double>::infinity();

  void rhs(double t, const double* y, double* dydt) const {
    if (pole) {
      dydt[0] = y[0] * y[0];
      dydt[1] = 0;
    } else {
      dydt[0] = y[1] + 2 * (std::sin(t) - y[0]) * y[1];
      dydt[1] = -y[0] + 1.5 * (std::cos(t) - y[1]) * y[0];
    }
    if (t > nan_after) dydt[1] = std::numeric_limits<double>::quiet_NaN();
  }
  void jacobian(double t, const double* y, double* j) const {
    j[0] = pole ? 2 * y[0] : -2 * y[1];
    j[1] = pole ? 0 : 1 + 2 * (std::sin(t) - y[0]);
    j[2] = pole ? 0 : -1 + 1.5 * (std::cos(t) - y[1]);
    j[3] = pole ? 0 : -1.5 * y[0];
  }
  void time_derivative(double t, const double* y, double* d) const {
    d[0] = pole ? 0 : 2 * std::cos(t) * y[1];
    d[1] = pole ? 0 : -1.5 * std::sin(t) * y[0];
  }
};

/// y' = -1e5 (y - 1) from y = 2, which asks for first steps of some 1e-8.
struct Approach {
  static constexpr std::size_t dimension = 1;
  static constexpr double rate = 1e5;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = -rate * (y[0] - 1); }
  void jacobian(double, const double*, double* j) const { j[0] = -rate; }
};

/// More unknowns than the limit for dense matrices, and no Jacobian.
struct Wide {
  static constexpr std::size_t dimension = dynamic;
  std::size_t size() const { return dense_dimension_limit + 1; }
  void rhs(double, const double* y, double* dydt) const {
    for (std::size_t i = 0; i < size(); ++i) dydt[i] = -y[i];
  }
};

inline const std::vector<double> circle_stops = {0.5, 1, 2};

template <Ode P>
Contest<P> contest_of(P problem, std::vector<double> y0) {
  Contest<P> contest;
  contest.problem = std::make_shared<const P>(std::move(problem));
  contest.y0 = std::make_shared<const std::vector<double>>(std::move(y0));
  return contest;
}

inline Contest<Circle> circle(Circle problem = {}) {
  return contest_of(problem, problem.pole ? std::vector<double>{1, 0} : std::vector<double>{0, 1});
}

inline const Entrant& find(const std::vector<Entrant>& entrants, const std::string& method) {
  for (const Entrant& entrant : entrants)
    if (entrant.info.method == method) return entrant;
  throw std::logic_error("no entrant " + method);
}

inline Request fixed_request(std::uint64_t steps) {
  Request request;
  request.steps = steps;
  request.stops = circle_stops;
  return request;
}
inline Request adaptive_request(double tolerance) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = tolerance;
  request.stops = circle_stops;
  return request;
}

/// Largest error over all stops; infinite where the solve was not ok.
inline double circle_error(const Outcome& outcome) {
  if (outcome.status != Status::ok) return std::numeric_limits<double>::infinity();
  double error = 0;
  for (std::size_t k = 0; k < circle_stops.size(); ++k) {
    error = std::max(error, std::abs(outcome.states[2 * k] - std::sin(circle_stops[k])));
    error = std::max(error, std::abs(outcome.states[2 * k + 1] - std::cos(circle_stops[k])));
  }
  return error;
}

/// The slope of the last doubling of steps, from `coarsest` on, whose finer error is above `floor`:
/// 1e-11 is a hundred times the rounding of some thousand steps.
inline double circle_order(const Entrant& entrant, std::uint64_t coarsest, double floor = 1e-11) {
  double order = std::numeric_limits<double>::quiet_NaN(), previous = order;
  for (std::uint64_t n = coarsest; n <= 256 * coarsest; n *= 2) {
    const double error = circle_error(entrant.solve(fixed_request(n)));
    if (!(error > floor)) break;
    order = std::log2(previous / error);
    previous = error;
  }
  return order;
}

/// The requirements on every entrant: at a fixed step, with faults and adaptive.
inline void expect_honest(const Entrant& entrant,
                          const std::function<std::vector<Entrant>(Circle)>& enrolled) {
  SCOPED_TRACE(entrant.info.id());
  const auto with = [&](Circle problem, const Request& request) {
    return find(enrolled(problem), entrant.info.method).solve(request);
  };
  for (const Request& request : {fixed_request(64), adaptive_request(1e-6)}) {
    const bool offered = request.mode == Mode::fixed ? entrant.info.fixed : entrant.info.adaptive;
    const Outcome outcome = with({}, request);
    if (!offered) {
      EXPECT_EQ(outcome.status, Status::refused);
      EXPECT_FALSE(outcome.detail.empty());
      continue;
    }
    EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
    EXPECT_EQ(outcome.t, circle_stops.back());
    EXPECT_EQ(outcome.states.size(), 2 * circle_stops.size());
    EXPECT_GT(outcome.counters.rhs_evaluations, 0u);
    if (request.mode == Mode::fixed) {
      EXPECT_EQ(outcome.counters.steps, 64u);
    }

    const Outcome ill = with({.nan_after = 0.7}, request);
    EXPECT_NE(ill.status, Status::ok);
    EXPECT_NE(ill.detail.find("component 1"), std::string::npos) << ill.detail;

    Request poor = request;
    poor.budget.evaluations = 10;
    const Outcome broke = with({}, poor);
    EXPECT_EQ(broke.status, Status::over_budget) << broke.detail;
    EXPECT_LE(broke.counters.rhs_evaluations, 10u);

    if (request.mode == Mode::adaptive) {
      // y' = y^2 has no solution past t = 1: an end at t = 2 must not be reported as reached.
      Request past_the_pole = request;
      past_the_pole.budget.evaluations = 300'000;
      const Outcome blown = with({.pole = true}, past_the_pole);
      EXPECT_NE(blown.status, Status::ok);
      EXPECT_FALSE(blown.detail.empty());
    }
  }
}

/// Expects these solvers to go from the start of Approach to t = 1e9, whose rounding is over 1e-7.
inline void expect_long_horizon(const std::vector<Entrant>& entrants,
                                const std::vector<std::string>& methods) {
  Request request = adaptive_request(1e-6);
  request.stops = {1e9};
  request.budget.evaluations = 100'000;
  for (const std::string& method : methods) {
    const Outcome outcome = find(entrants, method).solve(request);
    ASSERT_EQ(outcome.status, Status::ok) << method << ": " << outcome.detail;
    // The equilibrium is attractive: what is left of local errors is some ten tolerances.
    EXPECT_NEAR(outcome.states.back(), 1, 1e-5) << method;
  }
}

/// From a tolerance of 1e-3 to 1e-7 an error in proportion would fall by 1e4. The slowest here,
/// rk1imp, steps as the root of its local error, so that its global error falls by 1e2; a third of
/// that is asked for, and an end below 1e-3.
inline void expect_converges_with_tolerance(const Entrant& entrant) {
  SCOPED_TRACE(entrant.info.id());
  const double loose = circle_error(entrant.solve(adaptive_request(1e-3)));
  const double tight = circle_error(entrant.solve(adaptive_request(1e-7)));
  EXPECT_LT(tight, loose / 30) << "loose " << loose << ", tight " << tight;
  EXPECT_LT(tight, 1e-3);
}

}  // namespace odeum::test
