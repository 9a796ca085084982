// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/control/adaptive.hpp"

namespace odeum {

/// Step doubling over any one-step method: one step of h against two of h/2. Above the upper bound
/// the step is repeated with h/2; below the lower bound the next one is 2h. The two half steps are
/// kept, without extrapolation, so the order stays the method's own.
///
/// The upper bound is a scaled difference of one. Doubling h multiplies the difference by about
/// 2^(p+1), so the lower bound is half of 2^-(p+1): a doubled step still lands below the upper one.
template <class Stepper, Ode P>
Outcome run_step_doubling(const Guarded<P>& problem, double t0, const State<P>& y0,
                          const Request& request, int order) {
  Stepper stepper(problem);
  State<P> whole = make_state(problem);
  const auto one_step = [&](double t, double h, State<P>& y) {
    if constexpr (requires { stepper.start(t, h, y); }) stepper.start(t, h, y);
    return stepper.step(t, h, y);
  };
  const auto trial = [&](double t, double h, const State<P>& y, State<P>& y_new, double& norm) {
    whole = y;
    Status status = one_step(t, h, whole);
    y_new = y;
    if (status == Status::ok) status = one_step(t, h / 2, y_new);
    if (status == Status::ok) status = one_step(t + h / 2, h / 2, y_new);
    for (std::size_t i = 0; i < y.size(); ++i) whole[i] -= y_new[i];
    norm = scaled_error_norm(whole, y, y_new, request.tolerance);
    return status;
  };
  constexpr double upper = 1;
  const double lower = upper * std::ldexp(0.5, -(order + 1));
  const auto decide = [&](double h, double norm) {
    if (norm > upper) return Decision{false, h / 2};
    return Decision{true, norm < lower ? 2 * h : h};
  };
  const double first =
      initial_step(problem, t0, y0, request.stops.back(), order, request.tolerance);
  return run_adaptive(problem, t0, y0, request, first, trial, decide);
}

}  // namespace odeum
