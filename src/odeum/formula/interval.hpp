// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "odeum/formula/graph.hpp"

namespace odeum::formula {

struct Interval {
  double low = 0, high = 0;
  double width() const { return high - low; }
  double middle() const { return low + (high - low) / 2; }
};

/// Several boxes are enclosed at once, since most of the time goes into finding the operations.
inline constexpr std::size_t lanes = 8;
using Intervals = std::array<Interval, lanes>;

/// Encloses the values of nodes over boxes of times and states: each operation's range over the
/// ranges of its arguments, outside of which no value is. Where an argument leaves the domain of a
/// function, what lies in the domain counts.
class Enclosure {
 public:
  struct Step {
    Op op = Op::constant;
    std::uint32_t a = 0, b = 0, c = 0;  ///< positions of the arguments; a: the index of a state
    Interval value = {};                ///< of a constant
    /// Not a sum or a product, and no quotient by a constant: what can be narrow.
    bool is_function = false;
  };

  Enclosure(const Graph& graph, const std::vector<Id>& roots);
  /// The values of all nodes, by step. The reference is valid up to the next call.
  const std::vector<Intervals>& operator()(const Intervals& t, const std::vector<Intervals>& y);
  const std::vector<Step>& steps() const { return steps_; }
  /// The position of a root among the steps.
  std::uint32_t place(std::size_t root) const { return roots_[root]; }

 private:
  std::vector<Step> steps_;
  std::vector<std::uint32_t> roots_;
  std::vector<Intervals> values_;
};

/// The range of one operation that is not a leaf.
Interval enclose(Op op, const Interval& a, const Interval& b, const Interval& c);

}  // namespace odeum::formula
