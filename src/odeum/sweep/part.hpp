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

/// A part as text, by which it is kept.
std::string text_of(const Part& part);
/// The part of the plan's members from `first` to before `last` in such a text; their results, as
/// many each as the plan has quantities, go to `results`. Throws study::ResultLost for a text that
/// is not that of a part, or of other members.
Part part_of(const std::string& text, const Plan& plan, std::uint64_t first, std::uint64_t last,
             double* results);

}  // namespace odeum::sweep
