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

void Printed::machine() const {
  if (!page_) return fmt::print("{}, compiled for {}\n", cpu_model(), instruction_set);
  double load = 0;
  std::ifstream("/proc/loadavg") >> load;
  fmt::print("{}, {}: {}, {} processors, load {:.1f} when it began; compiled for {} by {} {}.\n",
             page_, utc_text(std::chrono::system_clock::now()).substr(0, 10), cpu_model(),
             std::thread::hardware_concurrency(), load, instruction_set, compiler_name,
             compiler_version);
  std::fflush(stdout);
}

void Printed::title(const std::string& text) const {
  if (page_)
    fmt::print("\n| {} | goal | measured | interval | | |\n|---|---|---|---|---|---|\n", text);
  else
    fmt::print("\n{:<66} {:>10} {:>10} {:<16}\n", text, "goal", "measured", "interval");
}

void Printed::row(const Row& row) const {
  const std::string goal =
      std::isnan(row.goal) ? "" : (row.at_most ? "<= " : ">= ") + three_digits(row.goal, row.unit);
  const std::string interval =
      row.low > 0 ? fmt::format("{} to {}", three_digits(row.low), three_digits(row.high)) : "";
  constexpr const char* forms[] = {"{:<66} {:>10} {:>10} {:<16} {:<22} {}\n",
                                   "| {} | {} | {} | {} | {} | {} |\n"};
  fmt::print(fmt::runtime(forms[page_ ? 1 : 0]), row.what, goal,
             three_digits(row.measured, row.unit), interval, row.verdict(), row.note);
  std::fflush(stdout);
}

}  // namespace odeum::bench
