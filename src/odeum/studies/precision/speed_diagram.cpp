// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "odeum/report/chart.hpp"
#include "odeum/report/html.hpp"
#include "odeum/studies/precision/section.hpp"

namespace odeum::study {
namespace {

bool is_drawn(const PrecisionRow& row, double worst) {
  return row.repetitions > 0 && row.wall_ns_min > 0 && row.error > 0 && row.error <= worst;
}

std::string title_of(const PrecisionRow& row) {
  return fmt::format("{}/{}, {} {:.3g}: {}, error {:.2g}", row.library, row.solver,
                     row.mode == Mode::adaptive ? "tolerance" : "step", row.setting,
                     report::show_time(row.wall_ns_min), row.error);
}

// Between the times of two points the error of the faster one is what is reached: a staircase.
std::vector<report::ChartPoint> front_of(std::vector<PrecisionRow> rows) {
  mark_pareto(rows);
  std::vector<report::ChartPoint> points;
  for (const PrecisionRow& row : rows)
    if (row.pareto) points.emplace_back(row.wall_ns_min, row.error);
  std::sort(points.begin(), points.end());
  return points;
}

// The sixth colour is left out: it is too near the first, which is our own.
std::size_t style_of_library(std::size_t index) {
  return index < 5 ? index : std::min(index + 1, report::chart_styles - 1);
}

/// Of more points than this only those of the front say what they are: the others' texts would be
/// nine tenths of the page. The comparison on index.html tells all of them.
constexpr std::size_t few = 200;

}  // namespace

std::string speed_diagram(const std::vector<PrecisionRow>& rows,
                          const std::vector<std::string>& libraries, double floor, double worst) {
  std::vector<PrecisionRow> drawn, peers;
  report::Axis time, error;
  for (const PrecisionRow& row : rows) {
    if (!is_drawn(row, worst)) continue;
    time.include(row.wall_ns_min);
    error.include(row.error);
    drawn.push_back(row);
    if (row.library != "odeum") peers.push_back(row);
  }
  if (drawn.empty()) return {};
  report::Chart chart(report::large_chart, time.widened(1.4), error.widened(3),
                      {.x = "time per solve (minimum)",
                       .y = "largest error, absolute",
                       .description = "error against time per solve",
                       .x_tick = report::show_time});
  chart.level(floor, "truth's floor");
  // Own points last, so that they lie on top.
  for (std::size_t i = libraries.size(); i-- > 0;)
    for (const PrecisionRow& row : drawn)
      if (row.library == libraries[i])
        chart.mark({row.wall_ns_min, row.error}, style_of_library(i), row.pareto ? "" : "faint",
                   row.pareto || drawn.size() <= few ? title_of(row) : std::string());
  chart.stairs(front_of(std::move(peers)), "front peers");
  chart.stairs(front_of(std::move(drawn)), "front");
  return chart.svg();
}

std::string speed_legend(const std::vector<std::string>& libraries) {
  std::vector<report::Key> keys;
  for (std::size_t i = 0; i < libraries.size(); ++i)
    keys.push_back({.text = libraries[i], .style = style_of_library(i)});
  keys.push_back(
      {.text = "Pareto front: no solver is both faster and more accurate", .line = "front"});
  keys.push_back({.text = "the same of the peers alone", .line = "front peers"});
  return report::legend(keys);
}

}  // namespace odeum::study
