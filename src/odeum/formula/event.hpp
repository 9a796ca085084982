// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "odeum/formula/graph.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::formula {

/// What a text says to happen at times, or where an expression crosses zero.
struct Event {
  std::string name;  ///< for people: `y falling`
  Place place;
  Id when = no_node;               ///< the expression; no_node: at times
  int sense = 0;                   ///< 1: where it rises, -1: where it falls, 0: either
  std::vector<long double> times;  ///< ascending
  std::vector<std::pair<std::size_t, Id>> set;  ///< states and their new values
  bool stop = false;
  int order = 0;  ///< of what happens at once, those of a lower one come first
};

struct Problem;

/// Gives y the values after events at t: in ascending order, those of one order from the values
/// before all of them. A sentence where two of one order reset one state, or where a value is not
/// finite; else empty. Real is double or long double.
template <class Real>
class EventRules {
 public:
  /// `constant`: replaces each constant; empty: none.
  explicit EventRules(const Problem& problem, const std::function<Real(Real)>& constant = {});
  ~EventRules();
  EventRules(const EventRules&) = delete;
  EventRules& operator=(const EventRules&) = delete;
  std::string apply(Real t, const std::vector<std::size_t>& events, Real* y) const;
  /// The expressions of the events that have one, in their order.
  void functions(Real t, const Real* y, Real* values) const;

 private:
  struct Compiled;
  const Compiled* compiled_;
};
extern template class EventRules<double>;
extern template class EventRules<long double>;

/// The numbers of events with an expression.
std::vector<std::size_t> crossed_events(const Problem& problem);

}  // namespace odeum::formula
