// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/shared_contest.hpp"

/// Boost.Numeric.Odeint: every stepper that it has, instantiated for the type of the problem. The
/// shared types are compiled in this folder; for any other one include odeint/inlined.hpp.
namespace odeum::adapters::odeint {

template <Ode P>
void enroll(const Contest<P>& contest, std::vector<Entrant>& entrants);

/// Those on first-order systems, without the ones on uBLAS.
template <Ode P>
void enroll_first_order(const Contest<P>& contest, std::vector<Entrant>& entrants);

extern template void enroll_first_order(const Contest<SharedOde>&, std::vector<Entrant>&);
extern template void enroll(const Contest<SharedOde>&, std::vector<Entrant>&);
extern template void enroll(const Contest<SharedSecondOrder>&, std::vector<Entrant>&);
extern template void enroll(const Contest<SharedSeparable>&, std::vector<Entrant>&);

}  // namespace odeum::adapters::odeint
