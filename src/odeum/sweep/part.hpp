// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "odeum/sweep/sweep.hpp"

namespace odeum::sweep {

/// The rows of some members, in their order.
struct Part {
  std::string lines;  ///< of members.csv
  std::map<std::string, Ending> endings;
  std::uint64_t solved = 0, evaluations = 0;
};

/// Adds members to those that ended so, and keeps the first.
void add_ending(std::map<std::string, Ending>& endings, const std::string& status,
                const Ending& more);

/// A part as text, by which it is kept, and back; the results of its members, `quantities` each,
/// go to `results`. Throws std::runtime_error for a text that is none.
std::string text_of(const Part& part);
Part part_of(const std::string& text, std::size_t quantities, double* results);

}  // namespace odeum::sweep
