// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/brought/judgement.hpp"

namespace odeum::brought {

/// The runs of one series, from coarse to fine, and for each the rows that are compared: at the
/// times that all have, or where there is one run at its own.
struct Series {
  std::vector<const Trajectory*> runs;
  std::vector<std::vector<std::size_t>> rows;
  bool common = true;  ///< whether there are such times
};

/// The series of the runs, in the order of their first files.
std::vector<Series> series_of(const std::vector<Trajectory>& runs);

/// The case as far as a file has it: only its components are measured.
Case seen_by(const Case& c, const Trajectory& run);

/// A run against the truth at these rows; `scale` is the solution's size in the units of errors.
FileRow row_of_file(const Case& c, const Trajectory& run, const std::vector<std::size_t>& rows,
                    const Claim& claim, double scale);

}  // namespace odeum::brought
