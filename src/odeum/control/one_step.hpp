// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <limits>

#include "odeum/control/adaptive.hpp"
#include "odeum/control/slope_range.hpp"
#include "odeum/control/step_control.hpp"
#include "odeum/control/unseen_ends.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/dense_output.hpp"

/// Adaptive runs of one-step methods.
namespace odeum {

/// Trial steps of a method with an embedded estimate of the given order. A stepper that reuses its
/// stages (`advance`, `repeat`) is told the decision, one that solves equations (`solve_to`) the
/// tolerance.
///
/// Between the ends of a step: by the interpolant of a first-same-as-last tableau, which has its
/// slopes at both ends, where its order suffices (local error h^4 of Hermite's cubic up to order 4,
/// h^5 with the method's own row at order 5); else by a step aside.
template <class Stepper, class StepControl, Ode P, class M = void>
class EmbeddedPair {
 public:
  EmbeddedPair(const P& problem, const Tolerance& tolerance, int order)
      : problem_(problem),
        stepper_(problem),
        control_(order),
        error_(make_state(problem)),
        tolerance_(tolerance),
        scale_(tolerance, error_) {
    if constexpr (requires { stepper_.solve_to(tolerance); }) stepper_.solve_to(tolerance);
  }

  Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
    copy_components(y, y_new);
    begin_trial(problem_);
    const Status status = stepper_.step(t, h, y_new, error_);
    double square = status == Status::ok ? scaled_error_square(error_, y, y_new, scale_)
                                         : std::numeric_limits<double>::infinity();
    if (square <= 1 && !has_ends(problem_, t, h, y, y_new, scale_, stepper_))
      square = std::numeric_limits<double>::infinity();
    Decision decision = decide(control_, h, square);
    if constexpr (requires { Stepper::keeps_factors; })
      decision = without_small_growth(decision, h);
    if constexpr (requires { stepper_.advance(); })
      decision.accept ? stepper_.advance() : stepper_.repeat();
    return decision;
  }

  /// A stage at the state before is not that of the next step.
  void moved() {
    moved_ = true;
    if constexpr (requires { stepper_.forget(); }) stepper_.forget();
  }

  Status between(const StepMade<State<P>>& step, double time, State<P>& y) {
    if constexpr (interpolant_suffices) {
      stepper_.advance();  // exchanges the first and the last stage: back for the sum over stages
      interpolate<M>(stepper_, step.share(time), step.h, step.before, step.after,
                     stepper_.last_stage(), y);
      stepper_.advance();
      if (moved_) moved();
      return Status::ok;
    } else {
      Stepper aside(problem_);
      if constexpr (requires { aside.solve_to(tolerance_); }) aside.solve_to(tolerance_);
      return step_aside(step, time, y, [&](double t, double h, State<P>& at) {
        return aside.step(t, h, at) == Status::ok;
      });
    }
  }

 private:
  static constexpr bool interpolant_suffices = [] {
    if constexpr (
        requires { M::tableau.first_same_as_last(); } &&
        requires(Stepper & stepper) { stepper.last_stage(); })
      return M::tableau.first_same_as_last() &&
             (M::info.order <= 4 || (M::info.order == 5 && requires { M::dense_row; }));
    return false;
  }();

  const P& problem_;
  Stepper stepper_;
  StepControl control_;
  State<P> error_;
  Tolerance tolerance_;
  ErrorScale<State<P>> scale_;
  bool moved_ = false;
};

/// Step doubling over any one-step method: one step of h against two of h/2. Above the upper bound
/// the step is repeated with h/2; below the lower bound the next one is 2h. The two half steps are
/// kept, without extrapolation, so the order stays the method's own. A stepper that makes an effort
/// where a failure would end the run (`will_be_retried`) is told that it does not.
///
/// The upper bound is a scaled difference of one. Doubling h multiplies the difference by about
/// 2^(p+1), so the lower bound is half of 2^-(p+1): a doubled step still lands below the upper one.
/// A step whose ends no stage sees is looked at there too (UnseenEnds).
template <class Stepper, Ode P>
class StepDoubling {
 public:
  StepDoubling(const P& problem, const Tolerance& tolerance, int order)
      : problem_(problem),
        stepper_(problem),
        whole_(make_state(problem)),
        ends_(problem, tolerance),
        scale_(tolerance, whole_),
        lower_(std::ldexp(0.5, -(order + 1))) {
    if constexpr (requires { stepper_.will_be_retried(); }) stepper_.will_be_retried();
  }

  Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
    whole_ = y;
    y_new = y;
    begin_trial(problem_);
    bool made = step(stepper_, t, h, whole_) && step(stepper_, t, h / 2, y_new);
    if (made) {
      ends_.remember_first_half(stepper_);
      made = step(stepper_, t + h / 2, h / 2, y_new);
    }
    each_component(y, [&](std::size_t i) { whole_[i] -= y_new[i]; });
    const double difference = scaled_error_norm(whole_, y, y_new, scale_);
    if (!made || !std::isfinite(difference)) return {false, h / 4};
    if (difference > 1 || !ends_.agree(stepper_, t, h, y, y_new) ||
        !has_ends(problem_, t, h, y, y_new, scale_, stepper_))
      return {false, h / 2};
    return {true, difference < lower_ ? 2 * h : h};
  }

  /// Two half steps aside, as in the step made.
  Status between(const StepMade<State<P>>& made, double time, State<P>& y) const {
    Stepper aside(problem_);
    return step_aside(made, time, y, [&](double t, double h, State<P>& at) {
      return step(aside, t, h / 2, at) && step(aside, t + h / 2, h / 2, at);
    });
  }

 private:
  static bool step(Stepper& stepper, double t, double h, State<P>& y) {
    if constexpr (requires { stepper.start(t, h, y); }) stepper.start(t, h, y);
    return stepper.step(t, h, y) == Status::ok;
  }

  const P& problem_;
  Stepper stepper_;
  State<P> whole_;
  UnseenEnds<Stepper, P> ends_;
  ErrorScale<State<P>> scale_;
  double lower_;
};

}  // namespace odeum
