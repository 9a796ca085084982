// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/kernel/method.hpp"
#include "odeum/solvers/enroll_as.hpp"
#include "odeum/solvers/lane_members.hpp"
#include "odeum/solvers/own_methods.hpp"
#include "odeum/solvers/shared_contest.hpp"

namespace odeum {

/// What a method's file says about it, as any library's solver says it.
template <class M>
SolverInfo info_of_own() {
  SolverInfo info;
  info.library = "odeum";
  info.method = M::info.id;
  info.family = M::info.family;
  if (M::info.order != 0) info.order = M::info.order;
  info.fixed = M::info.fixed_step;
  info.adaptive = ChoosesItsOwnSteps<M> || M::info.one_step;
  info.adaptive_order = M::info.adaptive_order;
  info.common_use = M::info.common_use;
  if (ChoosesItsOwnSteps<M>)
    info.controller = M::info.controller;
  else if (M::info.order_embedded != 0)
    info.controller = ControlFor<M::info.control>::type::name;
  else if (M::info.one_step)
    info.controller = "step doubling";
  info.needs = M::needs;
  info.source = M::info.source;
  if constexpr (requires { M::rounding(); }) info.rounding = M::rounding();
  if constexpr (requires { M::amplification(0.0, 0.0); }) {
    info.amplification = M::amplification;
    info.oscillator_amplification = [](double w) { return M::amplification(0, w); };
  }
  if constexpr (requires { M::oscillator_map(0.0); })
    info.oscillator_amplification = [](double w) { return spectral_radius(M::oscillator_map(w)); };
  return info;
}

/// Puts M on a contest behind pointers. What fits any problem is compiled for SharedOde alone.
template <class M>
void enroll_method(const ErasedContest& contest, Entrant& entrant) {
  entrant.unfit = "needs " + std::string(M::needs);
  if constexpr (requires { typename M::template StepperOfDigits<ExtendedProblem>; })
    entrant.extended = run_extended<typename M::template StepperOfDigits<ExtendedProblem>>;
  if constexpr (M::template fits<SharedOde>)
    enroll_as<M>(shared_contest<SharedOde>(contest), entrant);
  else
    with_shared_type(contest.view, [&]<Shared P>() {
      if constexpr (M::template fits<P>) enroll_as<M>(shared_contest<P>(contest), entrant);
    });
}

template <class M>
Solver own_method() {
  Solver solver{info_of_own<M>(), enroll_method<M>};
  if constexpr (RunsInLanes<M>) solver.lanes = lane_run_of<M>;
  return solver;
}

}  // namespace odeum
