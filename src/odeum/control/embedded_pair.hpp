// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/control/adaptive.hpp"
#include "odeum/control/step_control.hpp"

namespace odeum {

/// An embedded pair under a control of step_control.hpp; `lower_order` is the lower of its two
/// orders. A stepper that reuses stages is told whether the step was accepted.
template <class Stepper, class StepControl = IntegralControl, Ode P>
Outcome run_embedded_pair(const Guarded<P>& problem, double t0, const State<P>& y0,
                          const Request& request, int lower_order) {
  Stepper stepper(problem);
  StepControl control(lower_order);
  State<P> error = make_state(problem);
  const auto trial = [&](double t, double h, const State<P>& y, State<P>& y_new, double& norm) {
    y_new = y;
    const Status status = stepper.step(t, h, y_new, error);
    norm = scaled_error_norm(error, y, y_new, request.tolerance);
    return status;
  };
  const auto settle = [&](bool accepted) {
    if constexpr (requires { stepper.advance(); }) {
      if (accepted)
        stepper.advance();
      else
        stepper.repeat();
    }
  };
  const double first =
      initial_step(problem, t0, y0, request.stops.back(), lower_order, request.tolerance);
  return run_adaptive(problem, t0, y0, request, first, trial, control, settle);
}

}  // namespace odeum
