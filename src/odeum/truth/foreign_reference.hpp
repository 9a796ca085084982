// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>

#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// A solution that changes and is the same again within less than this part of the horizon may be
/// passed over: the right-hand side is sampled at such distances.
inline constexpr double shortest_seen = 1e-4;

/// The reference of a problem without an exact solution (compute_reference): steps in
/// extended precision over a right-hand side whose rounding is that of double, in a process of its
/// own. Nothing, and `why`, where the problem is too large, or its code fails or takes longer than
/// a minute.
std::optional<Reference> reference_of(const foreign::ProblemCallbacks& given, std::string& why,
                                      const TruthBounds& bounds = {});

}  // namespace odeum::truth
