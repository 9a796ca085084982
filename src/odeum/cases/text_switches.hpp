// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <vector>

#include "odeum/formula/problem.hpp"
#include "odeum/problem/piece.hpp"
#include "odeum/solvers/entrants.hpp"

namespace odeum::cases {

/// The switches of a problem up to `end`, with the sides on which conditions have settled.
std::vector<Switch> switches_of(const formula::Problem& problem, double end);

/// What ErasedContest::switches is of a problem; empty where no condition is one of the time alone.
/// They are computed once for each end.
std::function<std::vector<Switch>(double from, double to)> switches_of(
    const formula::Problem& problem);

/// The switches at or after `from`.
std::vector<Switch> from_time(std::vector<Switch> switches, double from);

/// Bounds the runs of a solution that stays where a condition changes. A run to a tolerance beyond
/// that time crosses the condition again and again, a tolerance apart, and makes no way. It ends
/// after five million evaluations or two seconds, and says why.
Entrants::Finish bound_by_sliding(double slides_from);

}  // namespace odeum::cases
