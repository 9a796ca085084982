// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <vector>

#include "odeum/formula/graph.hpp"

namespace odeum::formula {

/// A function that is given by its values at points.
struct Table {
  enum class Between { linear, cubic, constant };
  enum class Outside { error, hold, extrapolate };
  std::vector<long double> x, y;  ///< x ascending, two at least
  Between between = Between::linear;
  Outside outside = Outside::error;
};
inline constexpr std::size_t most_points = 2000;

/// Whether a table has values, or is said to go on, from a time to another.
inline bool covers(const Table& table, std::pair<long double, long double> span) {
  return table.outside != Table::Outside::error ||
         (table.x.front() <= span.first && table.x.back() >= span.second);
}

/// The value of a table at an expression: between its points a line, the natural cubic spline, or
/// the value at the point before; outside of them no value (not a number), that at the end, or what
/// holds in the last interval. Each point is a comparison, so that a run knows its kink.
Id value_at(Graph& graph, const Table& table, Id at);

}  // namespace odeum::formula
