// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/cases/inlined_contest.hpp"
#include "odeum/solvers/enroll_as.hpp"
#include "odeum/solvers/own_methods.hpp"

/// Solvers for timed runs only, with the right-hand side inlined and no guard. They compile slowly.
/// CMake generates a unit for each method whose file says `inlined`, with all problems of
/// cases/inlined, and one for each of these problems with odeint's steppers.
namespace odeum::cases::inlined {

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
