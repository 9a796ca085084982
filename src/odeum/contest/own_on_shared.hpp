// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/contest/solver.hpp"
#include "odeum/problem/shared.hpp"

namespace odeum {

/// The same contest, its second-order side forgotten.
template <Shared P>
Contest<SharedOde> as_first_order(const Contest<P>& contest) {
  return {contest.problem, contest.t0, contest.y0, contest.scene};
}

/// Enrols every own method, see own_solvers.hpp. Compiled for the shared types, once each.
template <Ode P>
void enroll_own(const Contest<P>& contest, std::vector<Entrant>& entrants);

extern template void enroll_own(const Contest<SharedOde>&, std::vector<Entrant>&);
extern template void enroll_own(const Contest<SharedSecondOrder>&, std::vector<Entrant>&);
extern template void enroll_own(const Contest<SharedSeparable>&, std::vector<Entrant>&);

}  // namespace odeum
