// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "odeum/brought/errors_of_file.hpp"
#include "odeum/brought/trajectory.hpp"
#include "odeum/core/numbers.hpp"

/// What a run says of itself where no truth is known, as of a chaotic problem at late times.
namespace odeum::brought {

struct RowToRow {
  /// The largest error that a row gains over the one before, by the unit of time: against the
  /// solution from the row before, of which two methods of different families agree. NaN: they do
  /// for no row.
  double gain = nan;
  double written = nan;   ///< the largest share of it that the digits written explain
  std::size_t rows = 0;   ///< that were compared
  std::string invariant;  ///< of the problem, the one that changes most; empty: it names none
  double change = nan;    ///< by how much, over its size
};

/// Measures at most 24 of the rows of a run that has all components; of another one nothing is
/// known.
RowToRow row_to_row(const Case& c, const Trajectory& run, const std::vector<std::size_t>& rows);

/// For each run of a series its first row, and the rows at which all runs are still near one
/// another: what they gain there is gained from the same states.
std::vector<std::vector<std::size_t>> rows_of_near_states(const Case& c, const Series& series);

}  // namespace odeum::brought
