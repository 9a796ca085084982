// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::judge {

/// The sums sum_i w_i y_i that the equations of a case keep, whatever the state: rows of weights,
/// each with a 1 first and as many numbers as y0. Found from the right-hand side at random states;
/// none of more than 64 unknowns.
std::vector<std::vector<double>> linear_invariants(const Case& c);

/// A value of a state that the solution has nowhere below zero.
struct BelowZero {
  std::size_t component = 0;
  double value = 0, time = 0;
};
/// The most negative value of each such state, at the stops that the run reached; rounding and the
/// truth's own error aside. The most negative one beside the size of its state comes first. None
/// where nothing is known of the solution.
std::vector<BelowZero> below_zero(const Case& c, const Request& request, const Outcome& outcome);

/// What a run that ended `ok` shows of faults that an error at the end may hide, in sentences:
/// states that never reach their absolute tolerance along the solution, states below zero where the
/// solution is not, and sums that the equations keep and the run does not.
std::vector<std::string> remarks(const Case& c, const Request& request, const Outcome& outcome);

}  // namespace odeum::judge
