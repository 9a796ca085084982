// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/record/row.hpp"

namespace odeum::compare {

/// Which of two commands takes less processor time, measured in pairs.
struct TimesRow {
  std::string before, after;  ///< the commands, as a shell takes them
  double pairs = 0;
  double before_seconds = nan, after_seconds = nan;  ///< medians, processor time of a run
  double ratio = nan;                                ///< the median of after over before in a pair
  double ratio_low = nan, ratio_high = nan;          ///< its interval, 99.9 %

  static constexpr const char* file = "times.csv";
  static constexpr const char* shown =
      "pairs before_seconds:.4g after_seconds:.4g ratio:.4f ratio_low:.4f ratio_high:.4f";
  ODEUM_COLUMNS(before, after, pairs, before_seconds, after_seconds, ratio, ratio_low, ratio_high)

  /// Slower, with certainty, by more than `part`.
  bool is_slower(double part) const { return ratio_low > 1 && ratio > 1 + part; }
};

struct Times {
  std::vector<TimesRow> rows = {};
  static auto lists(auto& result) { return std::tie(result.rows); }
};

/// Processor time of the processes that this one has waited for.
double children_seconds();

/// Runs both commands in turn by a shell, `pairs` times after one pair that is not counted, their
/// order within a pair changing from one to the next; their output goes nowhere. The processor time
/// is that of a command and of what it waited for. The interval is that of the sign test: it needs
/// eleven pairs at least. Throws std::invalid_argument, with its exit code, for a command that
/// fails, and Interrupted. One at a time in a process. A test gives a clock of its own, in seconds,
/// which its commands move on.
TimesRow compare_times(const std::string& before, const std::string& after, std::size_t pairs,
                       const std::function<double()>& clock = children_seconds);

}  // namespace odeum::compare
