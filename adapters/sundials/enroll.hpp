// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::sundials {

/// Enrols every solver of CVODE and ARKODE. All of them fit any problem: the implicit ones use
/// difference quotients where it offers no Jacobian.
void enroll_erased(const ErasedContest& contest, std::vector<Entrant>& entrants);

template <Ode P>
void enroll(const Contest<P>& contest, std::vector<Entrant>& entrants) {
  enroll_erased(erase(contest), entrants);
}

}  // namespace odeum::adapters::sundials
