// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "goals.hpp"
#include "odeum/core/thread_time.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::bench {

std::vector<Timing> interleave(const std::vector<std::function<void()>>& rivals, double seconds,
                               bool pinned, bool processor) {
  const auto now = [&] {
    return processor
               ? processor_seconds()
               : std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
                     .count();
  };
  std::optional<study::Pinned> pin;
  if (pinned) pin.emplace();
  std::vector<study::Times> times(rivals.size());
  const double start = now();
  for (int round = 0; round < 3 || (now() - start < seconds && round < 50); ++round)
    for (std::size_t k = 0; k < rivals.size(); ++k) {
      const double begin = now();
      rivals[k]();
      times[k].ns.push_back(1e9 * (now() - begin));
    }
  std::vector<Timing> result;
  result.reserve(times.size());
  for (const study::Times& t : times) result.push_back({t.min() * 1e-9, t.median() * 1e-9});
  return result;
}

Row compare(std::string what, double goal, const Timing& ours, const Timing& theirs,
            std::string note) {
  return {.what = std::move(what),
          .goal = goal,
          .measured = theirs.min / ours.min,
          .low = theirs.min / ours.median,
          .high = theirs.median / ours.min,
          .note = std::move(note)};
}

void print(const Row& row) {
  const std::string goal =
      std::isnan(row.goal)
          ? ""
          : fmt::format("{}{:.3g}{}", row.at_most ? "<= " : ">= ", row.goal, row.unit);
  const std::string verdict = std::isnan(row.goal)       ? ""
                              : std::isnan(row.measured) ? "not measured"
                              : row.met()                ? "met"
                                                         : "NOT MET";
  const std::string interval =
      row.low > 0 ? fmt::format("[{:.3g}, {:.3g}]", row.low, row.high) : "";
  fmt::print("{:<66} {:>10} {:>10} {:<16} {:<12} {}\n", row.what, goal,
             std::isnan(row.measured) ? "-" : fmt::format("{:.3g}{}", row.measured, row.unit),
             interval, verdict, row.note);
  std::fflush(stdout);
}

}  // namespace odeum::bench
