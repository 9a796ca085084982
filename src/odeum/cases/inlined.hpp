// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <vector>

#include "odeum/cases/inlined_for.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/solvers/enroll_method.hpp"

/// Solvers for timed runs only, with the right-hand side inlined and no guard. They compile slowly.
/// CMake generates a unit for each method whose file says `inlined`, with all problems of
/// cases/inlined, and one for each of these problems with odeint's steppers.
namespace odeum::cases::inlined {

/// Whether a view is that of a P: each type's view has functions of its own. Instantiated in a unit
/// that is not timed (cases/inlined/CMakeLists.txt), since these functions compute results too.
template <Ode P>
bool views(const OdeView& view);

/// The contest of a case whose problem is a P; no problem in it where the case has another.
template <Ode P>
Contest<Bare<P>> bare_contest(const Case& c) {
  Contest<Bare<P>> contest;
  if (!views<P>(c.problem.view)) return contest;
  contest.problem =
      std::make_shared<const Bare<P>>(Bare<P>{*static_cast<const P*>(c.problem.view.problem)});
  contest.t0 = c.t0;
  contest.y0 = c.problem.y0;
  return contest;
}

template <class M, Ode P>
void add_if(const Case& c, std::vector<Entrant>& all) {
  if constexpr (suits<P>(M::inlined) && M::template fits<Bare<P>>) {
    const Contest<Bare<P>> contest = bare_contest<P>(c);
    if (!contest.problem) return;
    Entrant entrant;
    enroll_as<M>(contest, entrant);
    if (!entrant.solve) return;
    entrant.info = own_solver(M::info.id).info;
    all.push_back(std::move(entrant));
  }
}

/// Appends method M where the case has one of the problems.
template <class M, Ode... P>
void add_method(const Case& c, std::vector<Entrant>& all) {
  (add_if<M, P>(c, all), ...);
}

}  // namespace odeum::cases::inlined
