// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/control/step_control.hpp"
#include "odeum/kernel/radau.hpp"

namespace odeum {

/// Trial steps of a Radau IIA method under predictive control. The estimate is of order S, the
/// method of order 2S - 1: a step whose estimate meets the tolerance is far more accurate than
/// requested. Hence the estimate is held to 0.03 tol^((S+1)/2S), as in Hairer's codes, whose factor
/// 0.1 misses loose tolerances.
template <const auto& T, Ode P>
class RadauTrial {
 public:
  static constexpr int order = T.stages;  ///< of the estimate

  RadauTrial(const P& problem, const Tolerance& tolerance)
      : problem_(problem),
        tolerance_(held_tolerance(tolerance)),
        stepper_(problem, tolerance_, newton_fraction()),
        control_(order, 8) {}
  static Tolerance held_tolerance(const Tolerance& tolerance) {
    return tolerance.with_relative(0.03 *
                                   std::pow(tolerance.relative, (order + 1.0) / (2.0 * order)));
  }

  Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
    double error = 0;
    const bool solved = stepper_.step(t, h, y, y_new, error) == Status::ok && std::isfinite(error);
    contraction_ = solved ? stepper_.contraction() : std::numeric_limits<double>::infinity();
    if (!solved) return {false, h / 4};
    // Many Newton iterations limit the growth of the step.
    constexpr int most = RadauStepper<T, P>::max_iterations;
    const double effort = (1.0 + 2 * most) / (stepper_.iterations() + 2.0 * most);
    Decision decision = control_(h, std::pow(error / power(effort, order + 1), 2));
    decision.accept = error < 1;
    if (decision.accept) {
      stepper_.accept(h);
      return without_small_growth(decision, h);
    }
    stepper_.reject();
    return {false, std::min(decision.next_step, 0.9 * h)};
  }

  /// The contraction of Newton's iteration in the last step; 0: not known, infinite: it failed.
  double contraction() const { return contraction_; }

  /// A step aside, since the collocation polynomial has order S only; that where it fails.
  Status between(const StepMade<State<P>>& step, double time, State<P>& y) const {
    RadauStepper<T, P> aside(problem_, tolerance_, newton_fraction());
    const Status found = step_aside(step, time, y, [&](double t, double h, State<P>& at) {
      return aside.step_inside(stepper_, step.share(t), step.share(t + h), t, h, step.before, at);
    });
    if (found != Status::ok) stepper_.polynomial(step.share(time), step.before, y);
    return found;
  }

 private:
  /// Leaves the power 2S + 1 of the step, one above the method's own error of a step: at the same
  /// power the remainder was the larger one, and took the order from runs on smooth problems.
  double newton_fraction() const {
    constexpr double exponent = (2.0 * order + 1) / (order + 1.0) - 1;
    return std::max(std::numeric_limits<double>::epsilon() / tolerance_.relative,
                    std::min(0.03, std::pow(tolerance_.relative, exponent)));
  }

  const P& problem_;
  Tolerance tolerance_;
  RadauStepper<T, P> stepper_;
  PredictiveControl control_;
  double contraction_ = 0;
};

/// Base of a Radau IIA method of an odd number of stages.
template <const auto& T>
struct RadauMethod : FullyImplicitMethod<T> {
  template <Ode P>
  static auto trial_steps(const P& problem, double t0, const State<P>& y0, double end,
                          const Tolerance& tolerance) {
    using Trial = RadauTrial<T, P>;
    const Tolerance held = Trial::held_tolerance(tolerance);
    return TrialSteps<Trial>{initial_step(problem, t0, y0, end, Trial::order, held),
                             {problem, tolerance}};
  }
};

}  // namespace odeum
