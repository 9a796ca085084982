// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "odeum/brought/candidate.hpp"
#include "odeum/brought/trajectory.hpp"
#include "odeum/core/numbers.hpp"

namespace odeum::brought {

/// The method, or the method with a mistake, whose steps the rows of a file are, to all digits that
/// are written.
struct Likeness {
  std::string method;
  std::string mistake;      ///< empty: none
  double order = nan;       ///< the method's
  double rows = 0;          ///< how many were compared
  bool mechanical = false;  ///< the problem is of second order, y = [q, v]
  /// Other methods, or other mistakes of the method, that fit as well: equal on this problem, or as
  /// far as the digits go.
  std::vector<std::string> also;

  std::string text() const;  ///< a sentence
};

/// Tries the methods that Odeum has and the mistakes that people make, `claimed` (an own method's
/// id, or empty) first. Each candidate gets from rows of the file to the next one, and fits where
/// it is off by no more than half a unit of the last written place of those rows explains. Nothing
/// where none fits, where rows are not steps apart, or where methods of different orders fit. Cases
/// of up to 40 components whose file has all of them. Throws Interrupted.
std::optional<Likeness> likeness_of(const Case& c, const Trajectory& run,
                                    const std::string& claimed);

}  // namespace odeum::brought
