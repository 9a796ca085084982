// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <concepts>

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

/// The trial steps of an adaptive run of method M from t0 to `end`: its own, those of an embedded
/// pair, else step doubling.
template <class M, Ode P>
auto trial_steps_of(const P& problem, double t0, const State<P>& y0, double end,
                    const Tolerance& tolerance) {
  using Stepper = typename M::template Stepper<P>;
  if constexpr (M::info.order_embedded != 0) {
    using Trial = EmbeddedPair<Stepper, typename ControlFor<M::info.control>::type, P, M>;
    constexpr int order = std::min(M::info.order, M::info.order_embedded);
    return TrialSteps<Trial>{initial_step(problem, t0, y0, end, order, tolerance),
                             {problem, tolerance, order}};
  } else {
    constexpr int order = M::info.order;
    return TrialSteps<StepDoubling<Stepper, P>>{
        initial_step(problem, t0, y0, end, order, tolerance), {problem, tolerance, order}};
  }
}
template <OwnTrialSteps M, Ode P>
auto trial_steps_of(const P& problem, double t0, const State<P>& y0, double end,
                    const Tolerance& tolerance) {
  return M::trial_steps(problem, t0, y0, end, tolerance);
}

/// The run of method M that a request asks for.
template <class M, Ode P>
Outcome run_method(const P& problem, double t0, const State<P>& y0, const Request& request) {
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
