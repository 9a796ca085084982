// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <limits>

#include "odeum/control/adaptive.hpp"
#include "odeum/control/step_control.hpp"

/// Adaptive runs of one-step methods.
namespace odeum {

/// Trial steps of a method with an embedded estimate of the given order. A stepper that reuses its
/// stages (`advance`, `repeat`) is told the decision, one that solves equations (`solve_to`) the
/// tolerance.
template <class Stepper, class StepControl, Ode P>
class EmbeddedPair {
 public:
  EmbeddedPair(const Guarded<P>& problem, double tolerance, int order)
      : stepper_(problem), control_(order), error_(make_state(problem)), tolerance_(tolerance) {
    if constexpr (requires { stepper_.solve_to(tolerance); }) stepper_.solve_to(tolerance);
  }

  Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
    y_new = y;
    const Status status = stepper_.step(t, h, y_new, error_);
    Decision decision =
        decide(control_, h,
               status == Status::ok ? scaled_error_norm(error_, y, y_new, tolerance_)
                                    : std::numeric_limits<double>::infinity());
    if constexpr (requires { Stepper::keeps_factors; })
      decision = without_small_growth(decision, h);
    if constexpr (requires { stepper_.advance(); })
      decision.accept ? stepper_.advance() : stepper_.repeat();
    return decision;
  }

 private:
  Stepper stepper_;
  StepControl control_;
  State<P> error_;
  double tolerance_;
};

template <class Stepper, class StepControl = IntegralControl, Ode P>
Outcome run_embedded_pair(const Guarded<P>& problem, double t0, const State<P>& y0,
                          const Request& request, int order) {
  const double first =
      initial_step(problem, t0, y0, request.stops.back(), order, request.tolerance);
  return run_adaptive(problem, t0, y0, request, first,
                      EmbeddedPair<Stepper, StepControl, P>(problem, request.tolerance, order));
}

/// Step doubling over any one-step method: one step of h against two of h/2. Above the upper bound
/// the step is repeated with h/2; below the lower bound the next one is 2h. The two half steps are
/// kept, without extrapolation, so the order stays the method's own.
///
/// The upper bound is a scaled difference of one. Doubling h multiplies the difference by about
/// 2^(p+1), so the lower bound is half of 2^-(p+1): a doubled step still lands below the upper one.
template <class Stepper, Ode P>
class StepDoubling {
 public:
  StepDoubling(const Guarded<P>& problem, double tolerance, int order)
      : stepper_(problem),
        whole_(make_state(problem)),
        tolerance_(tolerance),
        lower_(std::ldexp(0.5, -(order + 1))) {}

  Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
    whole_ = y;
    y_new = y;
    const bool made = step(t, h, whole_) && step(t, h / 2, y_new) && step(t + h / 2, h / 2, y_new);
    for (std::size_t i = 0; i < y.size(); ++i) whole_[i] -= y_new[i];
    const double difference = scaled_error_norm(whole_, y, y_new, tolerance_);
    if (!made || !std::isfinite(difference)) return {false, h / 4};
    if (difference > 1) return {false, h / 2};
    return {true, difference < lower_ ? 2 * h : h};
  }

 private:
  bool step(double t, double h, State<P>& y) {
    if constexpr (requires { stepper_.start(t, h, y); }) stepper_.start(t, h, y);
    return stepper_.step(t, h, y) == Status::ok;
  }

  Stepper stepper_;
  State<P> whole_;
  double tolerance_, lower_;
};

template <class Stepper, Ode P>
Outcome run_step_doubling(const Guarded<P>& problem, double t0, const State<P>& y0,
                          const Request& request, int order) {
  const double first =
      initial_step(problem, t0, y0, request.stops.back(), order, request.tolerance);
  return run_adaptive(problem, t0, y0, request, first,
                      StepDoubling<Stepper, P>(problem, request.tolerance, order));
}

}  // namespace odeum
