// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <set>
#include <vector>

#include "odeum/formula/problem.hpp"

namespace odeum::formula {

/// Whether the value of an operation may have a kink or a jump at a zero of what it depends on.
bool is_switch(Op op);
/// Returns the expression that is zero at the kinks and jumps of a switch, and nowhere else.
Id zero_at_switch(Graph& graph, Node node);

/// The times at which a text itself says that its right-hand side has a kink or a jump: where a
/// comparison, or an abs, sign, floor, min or max, of expressions of the time and of constants
/// alone changes, as `if(t > 5, ...)` does at 5 and `max(sin(t), 0)` at each multiple of pi.
struct SwitchTimes {
  /// Ascending, after t0 and before the end. From each on, the sign of a condition is another one:
  /// the state at that time is the last before the switch, and its slope is not defined.
  std::vector<long double> times;
  /// The nodes of the problem's graph of which all switches up to the end are among the times, and
  /// which depend on no state.
  std::set<Id> nodes;
};

/// Whether there are such conditions; false where the time or the states are in none.
bool has_timed_switches(const Problem& problem);

/// For the values that the problem's parameters have. A condition with more switches than can be
/// separated, as one with infinitely many, is left out. `end`: after t0.
SwitchTimes switch_times(const Problem& problem, long double end);

/// The zeros of an expression of the time alone from one time to another, ascending; nothing where
/// they are too many, or too close to each other, to be separated.
std::optional<std::vector<long double>> zeros_in_time(Graph& graph, Id value, long double from,
                                                      long double to);

}  // namespace odeum::formula
