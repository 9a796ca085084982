// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

#include "odeum/control/fixed_step.hpp"
#include "odeum/control/one_step.hpp"
#include "odeum/kernel/method.hpp"

namespace odeum {

namespace detail {
/// The least that a problem can be, to ask a method what it has.
struct AnyProblem {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double*, double*) const {}
};
}  // namespace detail

/// A method with trial steps of its own, see kernel/method.hpp.
template <class M>
concept OwnTrialSteps = requires(const detail::AnyProblem& problem,
                                 const State<detail::AnyProblem>& y) {
  M::trial_steps(problem, 0.0, y, 1.0, 1e-3);
};

/// A method with an adaptive run of its own, or trial steps for one.
template <class M>
concept ChoosesItsOwnSteps = OwnTrialSteps<M> ||
    requires(const detail::AnyProblem& problem, const State<detail::AnyProblem>& y,
             const Request& request) {
  { M::integrate(problem, 0.0, y, request) } -> std::same_as<Outcome>;
};

/// Whether trial_steps_of has some of method M.
template <class M>
inline constexpr bool has_trial_steps = OwnTrialSteps<M> ||
                                        (!ChoosesItsOwnSteps<M> &&
                                         (M::info.order_embedded != 0 || M::info.one_step));

/// Whether steps of M to a tolerance leave out an end of each, see SlopeRange: unless the method
/// says so, where it is stepped by step doubling.
template <class M>
constexpr bool leaves_out_ends() {
  if constexpr (requires { M::leaves_out_ends; }) return M::leaves_out_ends;
  return !ChoosesItsOwnSteps<M> && M::info.order_embedded == 0;
}

/// Whether the estimate of M's error gives a jump or a kink inside of a step little or no weight,
/// as the method says of itself: see InnerKinks.
template <class M>
constexpr bool misses_kinks() {
  if constexpr (requires { M::misses_kinks; }) return M::misses_kinks;
  return false;
}

/// Whether M evaluates f at the end of each step, and takes it as that of the next one's start.
template <class M>
constexpr bool sees_ends() {
  if constexpr (requires { M::sees_ends; }) return M::sees_ends;
  return false;
}

namespace detail {
/// The trial steps of M: its own, those of an embedded pair, else step doubling.
template <class M, Ode P>
auto trial_steps_alone(const P& problem, double t0, const State<P>& y0, double end,
                       const Tolerance& tolerance) {
  if constexpr (OwnTrialSteps<M>) {
    return M::trial_steps(problem, t0, y0, end, tolerance);
  } else {
    using Stepper = typename M::template Stepper<P>;
    constexpr bool pair = M::info.order_embedded != 0;
    constexpr int order = pair ? std::min(M::info.order, M::info.order_embedded) : M::info.order;
    using Trial =
        std::conditional_t<pair,
                           EmbeddedPair<Stepper, typename ControlFor<M::info.control>::type, P, M>,
                           StepDoubling<Stepper, P>>;
    return TrialSteps<Trial>{initial_step(problem, t0, y0, end, order, tolerance),
                             {problem, tolerance, order}};
  }
}

/// Trial steps on a problem whose slopes are watched, to which they refer.
template <class M, Ode P>
class TrialInRange {
 public:
  TrialInRange(const P& problem, double t0, const State<P>& y0, double end,
               const Tolerance& tolerance)
      : held_(std::make_unique<Held>(problem, t0, y0, end, tolerance)) {}

  double first_step() const { return held_->steps.first_step; }
  Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
    return held_->steps.trial(t, h, y, y_new);
  }
  Status between(const StepMade<State<P>>& step, double t, State<P>& y) {
    return held_->steps.trial.between(step, t, y);
  }
  void moved() {
    if constexpr (requires { held_->steps.trial.moved(); }) held_->steps.trial.moved();
  }

 private:
  using Watched = InRange<P>;
  struct Held {
    Held(const P& problem, double t0, const State<P>& y0, double end, const Tolerance& tolerance)
        : range(problem, misses_kinks<M>(), sees_ends<M>()),
          watched(problem, range),
          steps(trial_steps_alone<M>(watched, t0, y0, end, tolerance)) {}
    SlopeRange<P> range;
    Watched watched;
    decltype(trial_steps_alone<M>(std::declval<const Watched&>(), 0.0,
                                  std::declval<const State<P>&>(), 0.0,
                                  std::declval<const Tolerance&>())) steps;
  };
  std::unique_ptr<Held> held_;
};
}  // namespace detail

/// The trial steps of an adaptive run of method M from t0 to `end`.
template <class M, Ode P>
auto trial_steps_of(const P& problem, double t0, const State<P>& y0, double end,
                    const Tolerance& tolerance) {
  if constexpr (leaves_out_ends<M>() || misses_kinks<M>()) {
    using Trial = detail::TrialInRange<M, P>;
    Trial trial(problem, t0, y0, end, tolerance);
    const double first_step = trial.first_step();
    return TrialSteps<Trial>{first_step, std::move(trial)};
  } else {
    return detail::trial_steps_alone<M>(problem, t0, y0, end, tolerance);
  }
}

/// The run of method M that a request asks for.
template <class M, Ode P>
Outcome run_method(const P& problem, double t0, const State<P>& y0, const Request& request) {
  if constexpr (WithProjection<P> && !M::info.one_step)
    if (offers_project(problem))
      return refused(
          "projection: needs a one-step method; the history of this one is of states "
          "before their projection");
  if (request.mode == Mode::fixed) {
    if constexpr (M::info.fixed_step)
      return run_fixed<typename M::template Stepper<P>>(problem, t0, y0, request);
    else
      return refused("chooses its own steps only");
  } else if constexpr (has_trial_steps<M>) {
    auto steps = trial_steps_of<M>(problem, t0, y0, request.stops.back(), request.tolerance);
    return run_adaptive(problem, t0, y0, request, steps.first_step, steps.trial);
  } else if constexpr (ChoosesItsOwnSteps<M>) {
    return M::integrate(problem, t0, y0, request);
  } else {
    return refused("runs at a fixed step only");
  }
}

}  // namespace odeum
