// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/solver.hpp"

/// The GNU Scientific Library's solvers of ordinary differential equations, gsl_odeiv2: eleven
/// steppers.
namespace odeum::adapters::gsl {

/// Adds every stepper of the library as an entrant of the contest.
void enroll(const ErasedContest& contest, std::vector<Entrant>& entrants);

template <Ode P>
void enroll(const Contest<P>& contest, std::vector<Entrant>& entrants) {
  enroll(erase(contest), entrants);
}

}  // namespace odeum::adapters::gsl
