// SPDX-License-Identifier: BSD-3-Clause
// Prints the table of speed goals, goal beside measured; see scripts/bench. No arguments: all
// groups; else those named. Exits 0 whatever the figures say: no test fails on a time.
#include "goals.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

#include "odeum/studies/stopwatch.hpp"

namespace odeum::bench {

std::vector<Timing> interleave(const std::vector<std::function<void()>>& rivals, double seconds,
                               bool pinned) {
  using Clock = std::chrono::steady_clock;
  std::optional<study::Pinned> pin;
  if (pinned) pin.emplace();
  std::vector<study::Times> times(rivals.size());
  const auto start = Clock::now();
  const auto spent = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  for (int round = 0; round < 3 || (spent() < seconds && round < 50); ++round)
    for (std::size_t k = 0; k < rivals.size(); ++k) {
      const auto begin = Clock::now();
      rivals[k]();
      times[k].ns.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
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

namespace {

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

}  // namespace
}  // namespace odeum::bench

int main(int argc, char** argv) {
  using namespace odeum::bench;
  struct Group {
    const char* name;
    const char* title;
    std::vector<Row> (*rows)();
  };
  constexpr Group groups[] = {
      {"kernel", "Forces of a cloth", cloth_kernel_rows},
      {"steps", "Steps of a cloth", cloth_step_rows},
      {"cloth", "A cloth at equal error", cloth_error_rows},
      {"fixed", "Fixed-step RK4 against the better of odeint's two", fixed_step_rows},
      {"evaluation", "What a step costs beyond the right-hand side, by unknowns", evaluation_rows},
      {"precision", "At equal error: time of the best peer / of the best own solver",
       precision_rows},
      {"advise", "Time of the setting advised / of the best of an exhaustive search", advise_rows},
      {"sparse", "Implicit methods on many unknowns", sparse_rows},
      {"fem", "Linear finite elements on a million triangles", fem_rows}};
  for (int i = 1; i < argc; ++i)
    if (std::none_of(std::begin(groups), std::end(groups),
                     [&](const Group& g) { return std::string(g.name) == argv[i]; })) {
      fmt::print(stderr,
                 "odeum_goals: no group {}; got {}, expected kernel, steps, cloth, fixed, "
                 "evaluation, precision, advise, sparse or fem\n",
                 argv[i], argv[i]);
      return 2;
    }
  const double before = odeum::study::calibration_ns();
  fmt::print("{:<66} {:>10} {:>10} {:<16}\n", "", "goal", "measured", "interval");
  for (const Group& group : groups) {
    if (argc > 1 && std::none_of(argv + 1, argv + argc,
                                 [&](const char* a) { return std::string(a) == group.name; }))
      continue;
    fmt::print("\n{}\n", group.title);
    for (const Row& row : group.rows()) print(row);
  }
  const double drift = odeum::study::calibration_ns() / before - 1;
  fmt::print("\nThe machine's speed changed by {:+.1f} % from the first row to the last{}.\n",
             100 * drift, std::abs(drift) > 0.05 ? ": take the figures with care" : "");
}
