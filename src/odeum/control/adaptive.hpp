// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "odeum/core/guarded.hpp"
#include "odeum/core/outcome.hpp"

namespace odeum {

/// sqrt(mean over components of (e_i / (tol + tol max(|y_i|, |y_new_i|)))^2): 1 at the tolerance
/// (Hairer, Norsett, Wanner, Solving ODEs I, (II.4.10)-(II.4.11)).
template <class S>
double scaled_error_norm(const S& error, const S& y, const S& y_new, double tolerance) {
  double sum = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double scale = tolerance * (1 + std::max(std::abs(y[i]), std::abs(y_new[i])));
    sum += (error[i] / scale) * (error[i] / scale);
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
  const double h1 =
      steepest <= 1e-15 ? std::max(1e-6, h0 * 1e-3) : std::pow(0.01 / steepest, 1.0 / (order + 1));
  return std::min({100 * h0, h1, horizon - t0});
}

/// A controller's decision after a trial step.
struct Decision {
  bool accept;
  double next_step;
};

/// The adaptive loop. `Trial` makes one trial step from (t, y) with h, leaves the new state in
/// y_new and returns the scaled error and status; `decide` accepts or rejects it and chooses the
/// next step; `settle` is told whether the step was accepted. The loop only shortens steps that
/// would pass a stop.
template <Ode P, class Trial, class Decide, class Settle>
Outcome run_adaptive(const Guarded<P>& problem, double t0, const State<P>& y0,
                     const Request& request, double first_step, Trial&& trial, Decide&& decide,
                     Settle&& settle) {
  Outcome outcome;
  State<P> y = y0, y_new = y0;
  double t = t0, h = first_step;
  for (const double stop : request.stops) {
    while (t < stop) {
      // Relative to t, not to the horizon: near t = 0 a first step may be very short.
      const double smallest = std::max(16 * std::numeric_limits<double>::epsilon() * std::abs(t),
                                       std::numeric_limits<double>::min());
      const bool last =
          t + h >= stop - 16 * std::numeric_limits<double>::epsilon() * std::abs(stop);
      const double h_used = last ? stop - t : h;
      outcome.t = t;
      if (!(h >= smallest)) {
        outcome.status = Status::step_too_small;
        outcome.detail = fmt::format("step {} at t = {} is at the rounding of t", h, t);
        return outcome;
      }
      double error = 0;
      const Status status = trial(t, h_used, y, y_new, error);
      if (problem.tripped()) return outcome;  // the guard has the reason
      const Decision decision = status == Status::ok && std::isfinite(error)
                                    ? decide(h_used, error)
                                    : Decision{false, h_used / 4};
      settle(decision.accept);
      if (decision.accept) {
        t = last ? stop : t + h_used;
        std::swap(y, y_new);
        ++outcome.counters.steps;
        // A step shortened to meet a stop does not limit the next one.
        h = last ? std::max(h, decision.next_step) : decision.next_step;
      } else {
        ++outcome.counters.rejected_steps;
        h = decision.next_step;
      }
    }
    outcome.record(stop, y.data(), y.size());
  }
  return outcome;
}

template <Ode P, class Trial, class Decide>
Outcome run_adaptive(const Guarded<P>& problem, double t0, const State<P>& y0,
                     const Request& request, double first_step, Trial&& trial, Decide&& decide) {
  return run_adaptive(problem, t0, y0, request, first_step, trial, decide, [](bool) {});
}

}  // namespace odeum
