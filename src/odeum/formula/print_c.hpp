// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/formula/analysis.hpp"

namespace odeum::formula {

/// The C text of a problem: functions with the signatures of OdeView (the dense Jacobian of few
/// states only), and rhs_extended and entries_extended in long double. Each node is computed once,
/// in the order in which the user wrote it. The text has no name and no character that the user
/// wrote: nodes and states are numbers.
std::string print_c(const Problem& problem, const Analysis& analysis);

}  // namespace odeum::formula
