// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "odeum/formula/graph.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::formula {

/// What a text says to happen at times, where an expression crosses zero, or where a condition
/// becomes true.
struct Event {
  std::string name;  ///< for people: `y falling`
  Place place;
  Id when = no_node;               ///< the expression; no_node: at times, or by a condition
  int sense = 0;                   ///< 1: where it rises, -1: where it falls, 0: either
  Id condition = no_node;          ///< 0 or 1; no_node: none
  bool initially = true;           ///< false: the condition counts as false before the start
  std::vector<long double> times;  ///< ascending
  std::vector<std::pair<std::size_t, Id>> set;  ///< states and their new values
  bool stop = false;
  int order = 0;          ///< of what happens at once, those of a lower one come first
  Id priority = no_node;  ///< before that, those of a higher one; no_node: 0
  Id delay = no_node;     ///< from the time it is called at to that it is carried out at
  bool early = false;     ///< its values are of the time it is called at
  bool persistent =
      true;  ///< false: withdrawn where the condition is false before it is carried out
};

/// A function whose sign decides what happens.
struct Watched {
  Id function = no_node;
  int sense = 0;                   ///< of an event's own: in which it happens
  std::size_t event = 0;           ///< whose own it is; no_event: conditions look at its sign
  std::vector<long double> zeros;  ///< of one of the time alone, ascending, after the start
  std::vector<int> sides;          ///< its sign before the first of them and after each
};
inline constexpr std::size_t no_event = static_cast<std::size_t>(-1);

struct Problem;
/// Finds out what has to be watched for the events of a problem; adds nodes to its graph.
void watch_events(Problem& problem);

}  // namespace odeum::formula
