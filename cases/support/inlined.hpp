// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "odeum/harness/case.hpp"
#include "odeum/harness/own_solvers.hpp"
#include "odeum_inlined.hpp"  // generated: ODEUM_INLINED_ODEINT where that adapter is built
#ifdef ODEUM_INLINED_ODEINT
#include "odeint/inlined.hpp"
#endif

/// Solvers for timed runs alone, with the right-hand side compiled into them and nothing watched:
/// heavy, one problem a file.
namespace odeum::cases::inlined {

/// Own methods and odeint's steppers on cases of problem P; none where the case has another
/// problem. Methods below order 4, and odeint's of many steps, are left to the shared types: at
/// equal error they are never the fastest.
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
    if constexpr (M::info.order >= 4) {
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
