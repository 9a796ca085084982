// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <vector>

#include "odeum/problem/events.hpp"
#include "odeum/solvers/solver.hpp"

namespace odeum {

/// Runs a solver from (t0, y0) as the request says.
using PartRun = std::function<Outcome(double t0, const std::vector<double>& y0, const Request&)>;
/// The same on the form of the problem that holds between two times, see Piece.
using SegmentRun = std::function<Outcome(double first, double last, double t0,
                                         const std::vector<double>& y0, const Request& request)>;

/// A run from event to event, the same for every solver: each part begins anew where the one before
/// ended, by the solver's own means, and has nothing of the events. Where a function crosses zero
/// is found in the states that a run gives within each of its steps, by the polynomial through nine
/// of them (control/zeros.hpp); then the part is made up to there. To a tolerance that costs about
/// two more runs of a part, which the counts leave out. At a fixed step the states are those of one
/// step from where the step began, and the run goes on with a shorter step to the next time of its
/// grid. A state at the time of an event is that after it. Where an event stops the run, later
/// states are that at its end. Events that follow one another ever faster end the run with a
/// status.
Outcome run_with_events(const ErasedContest& contest, const Request& request,
                        const SegmentRun& segment);

/// Whether the last of these times, of events in their order, follow one another without end within
/// a run of that span (infinitely many in a finite time, or chattering); the time since which, NaN
/// where they do not.
double without_end_since(const std::vector<double>& times, double span);

/// The time t, moved to the middle between the two events beside it where it is near to one: what
/// two runs that begin there differ by has then the derivatives of the times of events and of what
/// they reset. `times`: of the events, ascending; the run is from begin to end.
double between_events(double t, const std::vector<double>& times, double begin, double end);

/// A run that locates nothing: events are looked at where its steps end, by the signs of their
/// functions and by the clock, and happen there. `run` has the whole problem, whose right-hand side
/// changes as it may within a step.
Outcome run_as_it_comes(const ErasedContest& contest, const Request& request, const PartRun& run);

}  // namespace odeum
