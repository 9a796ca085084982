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

/// A method with an adaptive run of its own, see kernel/method.hpp.
template <class M>
concept ChoosesItsOwnSteps = requires(const Guarded<detail::AnyProblem>& problem,
                                      const State<detail::AnyProblem>& y, const Request& request) {
  { M::integrate(problem, 0.0, y, request) } -> std::same_as<Outcome>;
};

inline Outcome refusal(const char* why) {
  Outcome outcome;
  outcome.status = Status::refused;
  outcome.detail = why;
  return outcome;
}

/// The run of method M that a request asks for.
template <class M, Ode P>
Outcome run_method(const Guarded<P>& problem, double t0, const State<P>& y0,
                   const Request& request) {
  if (request.mode == Mode::fixed) {
    if constexpr (M::info.fixed_step)
      return run_fixed<typename M::template Stepper<Guarded<P>>>(problem, t0, y0, request);
    else
      return refusal("chooses its own steps only");
  } else if constexpr (ChoosesItsOwnSteps<M>) {
    return M::integrate(problem, t0, y0, request);
  } else if constexpr (M::info.order_embedded != 0) {
    return run_embedded_pair<typename M::template Stepper<Guarded<P>>,
                             typename ControlFor<M::info.control>::type>(
        problem, t0, y0, request, std::min(M::info.order, M::info.order_embedded));
  } else if constexpr (M::info.one_step) {
    return run_step_doubling<typename M::template Stepper<Guarded<P>>>(problem, t0, y0, request,
                                                                       M::info.order);
  } else {
    return refusal("runs at a fixed step only");
  }
}

}  // namespace odeum
