// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "odeum/core/outcome.hpp"
#include "odeum/problem/concepts.hpp"

/// Small problems with closed solutions, and the order of a stepper measured on them.
namespace odeum::tests {

/// q'' = -q / |q|^3 from the perihelion of an orbit of eccentricity 0.3 and period 2 pi.
struct Kepler {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = false;
  static constexpr double e = 0.3;
  void acceleration(double, const double* q, const double*, double* a) const {
    const double r2 = q[0] * q[0] + q[1] * q[1], r3 = r2 * std::sqrt(r2);
    a[0] = -q[0] / r3;
    a[1] = -q[1] / r3;
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 2, t, y, dydt);
  }
  static State<Kepler> exact(double t) {
    double anomaly = t;  // E - e sin E = t, a contraction by e
    for (int i = 0; i < 60; ++i) anomaly = t + e * std::sin(anomaly);
    const double rate = 1 / (1 - e * std::cos(anomaly)), axis = std::sqrt(1 - e * e);
    return {std::cos(anomaly) - e, axis * std::sin(anomaly), -std::sin(anomaly) * rate,
            axis * std::cos(anomaly) * rate};
  }
};

/// q'' = sin^3 t - sin t - q^3 with q = sin t: nonlinear and driven.
struct Driven {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = false;
  void acceleration(double t, const double* q, const double*, double* a) const {
    const double s = std::sin(t);
    a[0] = s * s * s - s - q[0] * q[0] * q[0];
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
  static State<Driven> exact(double t) { return {std::sin(t), std::cos(t)}; }
};

template <class S>
double distance(const S& x, const S& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += (x[i] - y[i]) * (x[i] - y[i]);
  return std::sqrt(sum);
}

/// The error of a run in `steps` equal steps from the exact state at t0 to t1, in the mean over the
/// states (root of mean squares): the error at one time may happen to pass through zero.
template <template <class> class Stepper, class P>
double error_of_run(const P& problem, double t0, double t1, int steps) {
  Stepper<P> stepper(problem);
  State<P> y = P::exact(t0);
  const double h = (t1 - t0) / steps;
  if constexpr (requires { stepper.start(t0, h, y); }) stepper.start(t0, h, y);
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    stepper.step(t0 + i * h, h, y);
    const double error = distance(y, P::exact(t0 + (i + 1) * h));
    sum += error * error;
  }
  return std::sqrt(sum / steps);
}

/// The slope of the error over one halving of the step, from where the error first is below
/// 10^-(2 order + 1) or 1e-9: order 10 is then still clear of rounding.
template <template <class> class Stepper, class P>
double measured_order(const P& problem, double t0, double t1, int order) {
  const double start = std::max(1e-9, std::pow(10, -2 * order - 1));
  int steps = 4;
  double error = error_of_run<Stepper>(problem, t0, t1, steps);
  while (!(error < start) && steps < 1 << 16) {
    steps += (steps + 3) / 4;
    error = error_of_run<Stepper>(problem, t0, t1, steps);
  }
  return std::log2(error / error_of_run<Stepper>(problem, t0, t1, 2 * steps));
}

}  // namespace odeum::tests
