// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Problems for implicit methods with their solutions, and runs on them.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "odeum/kernel/method.hpp"
#include "support/own_runs.hpp"

namespace odeum::tests {

/// y'' + y'/2 + 5 y = 0.
struct LinearOscillator {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = y[1];
    dydt[1] = -5 * y[0] - 0.5 * y[1];
  }
  void jacobian(double, const double*, double* j) const {
    j[0] = 0;
    j[1] = 1;
    j[2] = -5;
    j[3] = -0.5;
  }
  static State<LinearOscillator> exact(double t) {
    const double a = 0.25, w = std::sqrt(5 - a * a), decay = std::exp(-a * t);
    return {decay * (std::cos(w * t) + a / w * std::sin(w * t)), -decay * 5 / w * std::sin(w * t)};
  }
};

/// u' = u (1 - u), v' = -u v: u = u0 e^t / g and v = 1 / g with g = 1 + u0 (e^t - 1). Its Jacobian
/// is taken by differences.
struct Logistic {
  static constexpr std::size_t dimension = 2;
  static constexpr double u0 = 0.25;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = y[0] * (1 - y[0]);
    dydt[1] = -y[0] * y[1];
  }
  static State<Logistic> exact(double t) {
    const double growth = 1 + u0 * (std::exp(t) - 1);
    return {u0 * std::exp(t) / growth, 1 / growth};
  }
};

/// The same with its Jacobian, and a count of its evaluations.
struct AnalyticLogistic : Logistic {
  mutable int jacobians = 0;
  void jacobian(double, const double* y, double* j) const {
    ++jacobians;
    j[0] = 1 - 2 * y[0];
    j[1] = 0;
    j[2] = -y[1];
    j[3] = -y[0];
  }
};

/// u' = -u^2 cos t, v' = -2 t v + u - 1 / (1 + sin t): u = 1 / (1 + sin t), v = exp(-t^2).
struct DrivenDecay {
  static constexpr std::size_t dimension = 2;
  void rhs(double t, const double* y, double* dydt) const {
    dydt[0] = -y[0] * y[0] * std::cos(t);
    dydt[1] = -2 * t * y[1] + y[0] - 1 / (1 + std::sin(t));
  }
  void jacobian(double t, const double* y, double* j) const {
    j[0] = -2 * y[0] * std::cos(t);
    j[1] = 0;
    j[2] = 1;
    j[3] = -2 * t;
  }
  void time_derivative(double t, const double* y, double* dfdt) const {
    const double s = 1 + std::sin(t);
    dfdt[0] = y[0] * y[0] * std::sin(t);
    dfdt[1] = -2 * y[1] + std::cos(t) / (s * s);
  }
  static State<DrivenDecay> exact(double t) { return {1 / (1 + std::sin(t)), std::exp(-t * t)}; }
};

struct Robertson {
  static constexpr std::size_t dimension = 3;
  static constexpr State<Robertson> start() { return {1, 0, 0}; }
  void rhs(double, const double* y, double* dydt) const {
    const double slow = 0.04 * y[0], back = 1e4 * y[1] * y[2], fast = 3e7 * y[1] * y[1];
    dydt[0] = -slow + back;
    dydt[1] = slow - back - fast;
    dydt[2] = fast;
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = -0.04;
    j[1] = 1e4 * y[2];
    j[2] = 1e4 * y[1];
    j[3] = 0.04;
    j[4] = -1e4 * y[2] - 6e7 * y[1];
    j[5] = -1e4 * y[1];
    j[6] = 0;
    j[7] = 6e7 * y[1];
    j[8] = 0;
  }
};

struct VanDerPol {
  static constexpr std::size_t dimension = 2;
  static constexpr double mu = 1000;
  static constexpr State<VanDerPol> start() { return {2, 0}; }
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = y[1];
    dydt[1] = mu * (1 - y[0] * y[0]) * y[1] - y[0];
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = 0;
    j[1] = 1;
    j[2] = -2 * mu * y[0] * y[1] - 1;
    j[3] = mu * (1 - y[0] * y[0]);
  }
};

/// Schaefer's reactions of plant physiology; its Jacobian by differences.
struct Hires {
  static constexpr std::size_t dimension = 8;
  static constexpr State<Hires> start() { return {1, 0, 0, 0, 0, 0, 0, 0.0057}; }
  void rhs(double, const double* y, double* dydt) const {
    const double r = 280 * y[5] * y[7];
    dydt[0] = -1.71 * y[0] + 0.43 * y[1] + 8.32 * y[2] + 0.0007;
    dydt[1] = 1.71 * y[0] - 8.75 * y[1];
    dydt[2] = -10.03 * y[2] + 0.43 * y[3] + 0.035 * y[4];
    dydt[3] = 8.32 * y[1] + 1.71 * y[2] - 1.12 * y[3];
    dydt[4] = -1.745 * y[4] + 0.43 * y[5] + 0.43 * y[6];
    dydt[5] = -r + 0.69 * y[3] + 1.71 * y[4] - 0.43 * y[5] + 0.69 * y[6];
    dydt[6] = r - 1.81 * y[6];
    dydt[7] = -dydt[6];
  }
};

template <class M, Ode P>
Outcome run(const P& problem, double t0, const State<P>& y0, const Request& request) {
  return run_own(M::info.id, contest_on(problem, t0, {y0.begin(), y0.end()}), request);
}

template <class M, Ode P>
Outcome run_fixed_steps(const P& problem, const State<P>& y0, double horizon, std::uint64_t steps) {
  return run<M>(problem, 0, y0, {.mode = Mode::fixed, .steps = steps, .stops = {horizon}});
}

template <class M, Ode P>
Outcome run_to_tolerance(const P& problem, const State<P>& y0, double horizon, double tolerance) {
  return run<M>(problem, 0, y0,
                {.mode = Mode::adaptive, .tolerance = tolerance, .stops = {horizon}});
}

/// Largest error at the end; NaN where the run failed.
template <class S>
double end_error(const Outcome& outcome, const S& exact) {
  if (outcome.status != Status::ok) return std::numeric_limits<double>::quiet_NaN();
  double error = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    error = std::max(error, std::abs(outcome.states[i] - exact[i]));
  return error;
}

/// log2 of the ratio of errors when the steps are doubled.
template <class M, Ode P>
double measured_order(std::uint64_t steps, double horizon = 1.5) {
  const P problem;
  const auto y0 = P::exact(0), exact = P::exact(horizon);
  return std::log2(end_error(run_fixed_steps<M>(problem, y0, horizon, steps), exact) /
                   end_error(run_fixed_steps<M>(problem, y0, horizon, 2 * steps), exact));
}

}  // namespace odeum::tests
