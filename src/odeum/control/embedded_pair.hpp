// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/control/adaptive.hpp"

namespace odeum {

/// Integral control on an embedded pair: h <- h * clamp(0.9 err^(-1/(q+1)), 0.2, 5), with q the
/// lower of the two orders (Solving ODEs I, (II.4.13)).
template <class Stepper, Ode P>
Outcome run_embedded_pair(const Guarded<P>& problem, double t0, const State<P>& y0,
                          const Request& request, int lower_order) {
  Stepper stepper(problem);
  State<P> error = make_state(problem);
  const auto trial = [&](double t, double h, const State<P>& y, State<P>& y_new, double& norm) {
    y_new = y;
    const Status status = stepper.step(t, h, y_new, error);
    norm = scaled_error_norm(error, y, y_new, request.tolerance);
    return status;
  };
  const auto decide = [&](double h, double norm) {
    const double factor =
        std::clamp(0.9 * std::pow(std::max(norm, 1e-10), -1.0 / (lower_order + 1)), 0.2, 5.0);
    return Decision{norm <= 1, h * factor};
  };
  const double first =
      initial_step(problem, t0, y0, request.stops.back(), lower_order, request.tolerance);
  return run_adaptive(problem, t0, y0, request, first, trial, decide);
}

}  // namespace odeum
