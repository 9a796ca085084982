// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string_view>
#include <vector>

#include "odeum/contest/case.hpp"
#include "odeum/contest/own_solvers.hpp"
#include "odeum_inlined.hpp"  // generated: ODEUM_INLINED_ODEINT where that adapter is built
#ifdef ODEUM_INLINED_ODEINT
#include "odeint/inlined.hpp"
#endif

/// Solvers for timed runs only, with the right-hand side inlined and no guard. They compile slowly:
/// one problem per file.
namespace odeum::cases::inlined {

/// Whether a method may be the fastest at some error on a small smooth or stiff problem, so that it
/// is worth its compile time here: one-step methods of high order and those that are their
/// family's workhorse. All others are timed on the shared types.
template <class M>
constexpr bool contends() {
  constexpr std::string_view id = M::info.id;
  constexpr std::string_view list[] = {"rk4",
                                       "dormand_prince54",
                                       "dormand_prince853",
                                       "verner98",
                                       "dormand_nystroem64",
                                       "dormand_nystroem86",
                                       "gragg_bulirsch_stoer",
                                       "taylor",
                                       "velocity_verlet",
                                       "blanes_moan6",
                                       "rodas4",
                                       "rodas5p",
                                       "radau_iia5",
                                       "radau_iia9",
                                       "seulex",
                                       "bdf_variable",
                                       "exponential_propagator"};
  for (const std::string_view name : list)
    if (name == id) return true;
  return false;
}

/// Own methods that contend and odeint's one-step steppers on cases of problem P; none where the
/// case has another problem.
template <Ode P>
std::vector<Entrant> offer(const Case& c) {
  std::vector<Entrant> entrants;
  // A type's view has functions of its own: they tell whose problem it is.
  if (c.problem.view.rhs != view_of(P{}).rhs) return entrants;
  Contest<Bare<P>> contest;
  contest.problem =
      std::make_shared<const Bare<P>>(Bare<P>{*static_cast<const P*>(c.problem.view.problem)});
  contest.t0 = c.t0;
  contest.y0 = c.problem.y0;
  methods::All::for_each([&]<class M>() {
    if constexpr (contends<M>()) {
      Entrant entrant;
      entrant.info = info_of_own<M>();
      enroll_method<M>(contest, entrant);
      if (entrant.solve) entrants.push_back(std::move(entrant));
    }
  });
#ifdef ODEUM_INLINED_ODEINT
  adapters::odeint::Roster<Bare<P>> roster(contest, entrants);
  adapters::odeint::enroll_one_step(roster);
  adapters::odeint::enroll_extrapolation(roster);
  adapters::odeint::enroll_second_order(roster);
#endif
  return entrants;
}

}  // namespace odeum::cases::inlined
