// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <vector>

#include "odeum/formula/problem.hpp"

/// A problem with kinks and jumps as smooth ones: between the times at which a condition changes,
/// one alternative of each holds.
namespace odeum::formula {

/// By node of a comparison, abs, sign, min or max: the sign of what it depends on (b - a of a < b,
/// min and max of a and b; else the argument). 0: it is zero, and stays so.
using Signs = std::map<Id, int>;

struct Mode {
  Problem problem;           ///< equations without kinks
  Signs signs;               ///< of the nodes that matter in this mode; 0 where none was given
  std::vector<Id> ids;       ///< these nodes, in the order of `switches`
  std::vector<Id> switches;  ///< what they depend on, in the graph of `problem`
};

/// The equations with the alternatives that the signs select. `constant` replaces each constant.
Mode mode_of(const Problem& problem, const Signs& signs,
             const std::function<long double(long double)>& constant);

}  // namespace odeum::formula
