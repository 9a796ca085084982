// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <vector>

#include "odeum/formula/problem.hpp"

/// A problem with kinks and jumps as smooth ones: between the times at which a condition changes,
/// one alternative of each holds.
namespace odeum::formula {

/// Maps each switching node to the sign of its switching function: b - a for a < b, min and max of
/// a and b; the argument for abs and sign. 0 means that it stays zero. A node of floor has 2 n + 1,
/// if its argument lies between n and n + 1.
using Signs = std::map<Id, int>;

struct Mode {
  Problem problem;           ///< equations without kinks
  Signs signs;               ///< of the nodes that matter in this mode; 0 where none was given
  std::vector<Id> ids;       ///< these nodes, in the order of `switches`
  std::vector<Id> switches;  ///< what they depend on, in the graph of `problem`
  std::vector<bool> floors;  ///< whether node number k is one of floor
  std::vector<Id> events;    ///< the functions that are watched for events, in that graph

  /// The entry of Signs of node number k where what it depends on has this value.
  int sign(std::size_t k, long double value) const;
  /// What is positive in this mode by node number k, and zero where it ends; the sign is not 0.
  Id held(std::size_t k);
};

/// The equations with the alternatives that the signs select. `constant` replaces each constant.
Mode mode_of(const Problem& problem, const Signs& signs,
             const std::function<long double(long double)>& constant);

}  // namespace odeum::formula
