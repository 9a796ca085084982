// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>

#include "odeum/solvers/solver.hpp"

namespace odeum {

/// The solver on the problem. A run to a tolerance is made in pieces between the switches of the
/// contest, each begun anew from the end of the one before, as users of a library make it: a jump
/// in t alone costs no method its order, and no run steps over a pulse that its equations name.
/// Runs at a fixed step take t = t0 + i h as ever. On a contest with events runs go from event to
/// event, see event_run.hpp.
Entrant enrolled(const Solver& solver, const ErasedContest& contest);

/// The second entrant of a solver on a problem with switches or events, `<solver>_as_it_comes`,
/// which locates nothing, see event_run.hpp: what it costs to take them as they come. A list of
/// entrants has it by its id alone (Entrants::find), and does not count it.
Entrant enrolled_as_it_comes(const Solver& solver, const ErasedContest& contest);
inline constexpr std::string_view as_it_comes = "_as_it_comes";

}  // namespace odeum
