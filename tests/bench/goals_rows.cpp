// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <optional>
#include <thread>

#include "goals.hpp"
#include "odeum/core/clocks.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::bench {
namespace {

constexpr const char* instruction_set =
#if defined(__AVX512F__)
    "AVX-512";
#elif defined(__AVX2__)
    "AVX2";
#else
    "vectors of two numbers";
#endif
constexpr const char* compiler_name =
#ifdef __clang__
    "clang";
#else
    "g++";
#endif
constexpr const char* compiler_version = __VERSION__;

}  // namespace

std::vector<Timing> interleave(const std::vector<std::function<void()>>& rivals, double seconds,
                               bool pinned) {
  const auto now = [&] {
    return pinned
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
  const double measured = theirs.min / ours.min;
  // A median of differences may lie below the least of them.
  return {.what = std::move(what),
          .goal = goal,
          .measured = measured,
          .low = std::min(measured, theirs.min / ours.median),
          .high = std::max(measured, theirs.median / ours.min),
          .note = std::move(note)};
}

std::string compiled_for() { return instruction_set; }

std::string three_digits(double number, const std::string& unit) {
  if (std::isnan(number)) return "-";
  // Numbers of four digits and more have no exponent.
  return (std::abs(number) < 999.5 ? fmt::format("{:.3g}", number)
                                   : fmt::format("{:.0f}", number)) +
         unit;
}

std::string Row::verdict() const {
  if (disturbed) return "not judged: other programs ran";
  if (std::isnan(goal)) return "";
  if (std::isnan(measured)) return "not measured";
  if (met()) return "met";
  return fmt::format("NOT MET: {:.2f} of it", measured / goal);
}

void Printed::machine() {
  std::ifstream("/proc/loadavg") >> load_;
  date_ = utc_text(std::chrono::system_clock::now()).substr(0, 10);
  if (!as_rows_) fmt::print("{}, compiled for {}\n", cpu_model(), instruction_set);
}

void Printed::title(const std::string& text) {
  title_ = text;
  if (!as_rows_)
    fmt::print("\n{:<66} {:>10} {:>10} {:<16}\n", text, "goal", "measured", "interval");
}

void Printed::row(const Row& row) {
  rows_.emplace_back(title_, row);
  if (as_rows_) return;
  const std::string goal =
      std::isnan(row.goal) ? "" : (row.at_most ? "<= " : ">= ") + three_digits(row.goal, row.unit);
  const std::string interval =
      row.low > 0 ? fmt::format("{} to {}", three_digits(row.low), three_digits(row.high)) : "";
  fmt::print("{:<66} {:>10} {:>10} {:<16} {:<22} {}\n", row.what, goal,
             three_digits(row.measured, row.unit), interval, row.verdict(), row.note);
  std::fflush(stdout);
}

void Printed::end(double drift) {
  if (!as_rows_) {
    if (!std::isnan(drift))
      fmt::print("\nThe machine's speed changed by {:+.1f} % from the first row to the last{}.\n",
                 100 * drift, std::abs(drift) > 0.05 ? ": take the figures with care" : "");
    return;
  }
  record::Records table{{"instruction_set", "table", "what", "bound", "goal", "measured", "unit",
                         "low", "high", "verdict", "note", "date", "processor", "processors",
                         "load", "compiler", "drift"}};
  for (const auto& [title, row] : rows_) {
    const bool judged = !std::isnan(row.goal), interval = row.low > 0;
    const std::string word = row.disturbed              ? "disturbed"
                             : !judged                  ? ""
                             : std::isnan(row.measured) ? "not_measured"
                             : row.met()                ? "met"
                                                        : "missed";
    const std::size_t unit = row.unit.find_first_not_of(' ');
    table.rows.push_back({compiled_for(), title, row.what,
                          std::string(!judged       ? ""
                                      : row.at_most ? "at_most"
                                                    : "at_least"),
                          judged ? three_digits(row.goal) : "",
                          std::isnan(row.measured) ? "nan" : three_digits(row.measured),
                          unit == std::string::npos ? "" : row.unit.substr(unit),
                          interval ? three_digits(row.low) : "",
                          interval ? three_digits(row.high) : "", word, row.note, date_,
                          cpu_model(), static_cast<double>(std::thread::hardware_concurrency()),
                          load_, fmt::format("{} {}", compiler_name, compiler_version),
                          std::isnan(drift) ? "" : fmt::format("{:.3f}", drift)});
  }
  fmt::print("{}", table.csv());
}

}  // namespace odeum::bench
