// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "odeum/record/csv.hpp"
#include "odeum/solvers/settings.hpp"

namespace odeum::trajectories {

/// One solver's run of a case with its output times.
struct CaseRun {
  const Entrant* entrant = nullptr;
  Request request;
  Outcome outcome;

  std::size_t reached(std::size_t n) const { return outcome.states.size() / n; }  ///< stops
  /// The n numbers of the state at one of the stops.
  const double* state_at(double stop, std::size_t n) const {
    const auto at = std::ranges::find(request.stops, stop) - request.stops.begin();
    return outcome.states.data() + static_cast<std::size_t>(at) * n;
  }
};

/// The outcome of a run with its outputs. To a tolerance, a state between the steps costs
/// evaluations, and steps of some libraries end on outputs: the run is made without them, too, and
/// counts, steps, status and the end are those of that run. Outputs at which steps cannot end are
/// those of runs of their own.
Outcome solve_with_outputs(const Entrant& entrant, const Request& request);

/// The exact states of a case by time, where they are known.
struct ExactStates {
  std::map<double, std::vector<double>> states = {};
  bool everywhere = true;  ///< at all the times that were asked for: a line, not marks
  /// Bound of their error: the truth's, or the largest difference to it where they are computed.
  double floor = 0;
  std::string source = {};
};

/// The states of the truth at these times.
ExactStates true_states(const Case& c, const std::vector<double>& times);
/// The exact states at the outputs of all runs, and where a reference holds the truth at its times.
ExactStates exact_states(const Case& c, const std::vector<CaseRun>& runs);

/// A row for each output of each solver, for the states before and after each of its events, and
/// for each exact state (library `truth`): case, library, solver, time, the components by name,
/// energy, error.
record::Records case_trajectory(const Case& c, const std::vector<CaseRun>& runs,
                                const ExactStates& exact);
/// The end of each run: case, library, solver, status, time, component, value, exact, difference,
/// unit of errors, name.
record::Records case_solution(const Case& c, const std::vector<CaseRun>& runs);
/// The accepted steps of adaptive runs, where they are recorded: case, library, solver, time, step.
/// A run with more steps than this has them in as many groups of neighbours, and the table has the
/// shortest and the longest of each: a stiff run of an explicit method has 10^7.
inline constexpr std::size_t most_groups_of_steps = 20'000;
record::Records case_steps(const Case& c, const std::vector<CaseRun>& runs);

/// For pictures: states at the ends of steps, which lie where the solution moves fast and outputs
/// step over it, of another run that stops there; with the columns of case_schemes and the energy.
/// Many steps are thinned out evenly. A run whose outputs are the ends of its steps has no rows.
record::Records case_curves(const Case& c, const std::vector<CaseRun>& runs);

/// The scheme's own closed form at the outputs of each run that has one: case, library, solver,
/// time, the components by name.
record::Records case_schemes(const Case& c, const std::vector<CaseRun>& runs);

/// Largest difference between a run at a fixed step and the scheme's own closed form, over the
/// outputs; NaN where none is known.
double difference_to_scheme(const Case& c, const CaseRun& run);

}  // namespace odeum::trajectories
