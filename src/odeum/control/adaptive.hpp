// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "odeum/core/guarded.hpp"
#include "odeum/core/outcome.hpp"

/// The adaptive loop, and the interface of what chooses its steps. A `Trial` makes one trial step
/// of length h from (t, y), and accepts it, with the new state in y_new, or rejects it:
///
///     Decision operator()(double t, double h, const State<P>& y, State<P>& y_new);
///
/// It may offer besides
///
///     double longest_step(double t, const State<P>& y);   // known before the trial: replaces the
///                                                         // step that was decided on before
///     void interpolate(double t, State<P>& y) const;      // in the last accepted step: the loop
///                                                         // then steps over all stops but the
///                                                         last
///
/// One-step methods (one_step.hpp) leave the decision to a controller of step_control.hpp; methods
/// that choose their order as well (extrapolation, BDF) decide themselves.
namespace odeum {

/// After a trial step of h: `next_step` is the length of the repetition or of the following step.
struct Decision {
  bool accept;
  double next_step;
};

/// sqrt(mean over components of (e_i / (tol + tol max(|y_i|, |y_new_i|)))^2): 1 at the tolerance
/// (Hairer, Norsett, Wanner, Solving ODEs I, (II.4.10)-(II.4.11)); not finite where y_new is not.
template <class S>
double scaled_error_norm(const S& error, const S& y, const S& y_new, double tolerance) {
  double sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double scale = tolerance * (1 + std::max(std::abs(y[i]), std::abs(y_new[i])));
    sum += (error[i] / scale) * (error[i] / scale) + 0 * y_new[i];
  }
  return std::sqrt(sum / static_cast<double>(y.size()));
}

/// A first step for a method of the given order (Solving ODEs I, II.4, "Starting step size").
template <Ode P>
double initial_step(const Guarded<P>& problem, double t0, const State<P>& y0, double horizon,
                    int order, double tolerance) {
  State<P> f0 = make_state(problem), y1 = f0, f1 = f0;
  problem.rhs(t0, y0.data(), f0.data());
  const double d0 = scaled_error_norm(y0, y0, y0, tolerance);
  const double d1 = scaled_error_norm(f0, y0, y0, tolerance);
  const double h0 = std::min(d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * d0 / d1, horizon - t0);
  for (std::size_t i = 0; i < y0.size(); ++i) y1[i] = y0[i] + h0 * f0[i];
  problem.rhs(t0 + h0, y1.data(), f1.data());
  for (std::size_t i = 0; i < y0.size(); ++i) f1[i] -= f0[i];
  const double d2 = scaled_error_norm(f1, y0, y0, tolerance) / h0;
  const double steepest = std::max(d1, d2);
  const double h1 = steepest > 1e-15 && std::isfinite(steepest)
                        ? std::pow(0.01 / steepest, 1.0 / (order + 1))
                        : std::max(1e-6, h0 * 1e-3);
  return std::min({100 * h0, h1, horizon - t0});
}

/// Steps from t0 to the last stop; they are shortened only to end on a stop.
template <Ode P, class Trial>
Outcome run_adaptive(const Guarded<P>& problem, double t0, const State<P>& y0,
                     const Request& request, double first_step, Trial&& trial) {
  constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  constexpr bool interpolates = requires(State<P> & y) { trial.interpolate(t0, y); };
  Outcome outcome;
  State<P> y = y0, y_new = y0;
  double t = t0, h = first_step;
  for (const double stop : request.stops) {
    const double target = interpolates ? request.stops.back() : stop;
    while (t < stop) {
      outcome.t = t;
      if constexpr (requires { trial.longest_step(t, y); }) h = trial.longest_step(t, y);
      // Relative to t, not to the horizon: near t = 0 a first step may be very short.
      if (!(h >= std::max(rounding * std::abs(t), std::numeric_limits<double>::min()))) {
        outcome.status = Status::step_too_small;
        outcome.detail = fmt::format("step {} at t = {} is at the rounding of t", h, t);
        return outcome;
      }
      const bool last = t + h >= target - rounding * std::abs(target);
      const double h_used = last ? target - t : h;
      const Decision decision = trial(t, h_used, y, y_new);
      if (problem.tripped()) return outcome;  // the guard has the reason
      if (decision.accept) {
        t = last ? target : t + h_used;
        std::swap(y, y_new);
        ++outcome.counters.steps;
        // A step shortened to meet a stop does not limit the next one.
        h = last ? std::max(h, decision.next_step) : decision.next_step;
      } else {
        ++outcome.counters.rejected_steps;
        h = decision.next_step;
      }
    }
    if constexpr (interpolates)
      if (t > stop) trial.interpolate(stop, y_new);
    const State<P>& at_stop = t > stop ? y_new : y;
    outcome.record(stop, at_stop.data(), at_stop.size());
  }
  return outcome;
}

}  // namespace odeum
