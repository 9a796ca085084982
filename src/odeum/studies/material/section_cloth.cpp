// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/studies/material/section.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::study {
namespace {

using report::Cell;
using report::escape;
using report::show_number;

/// What is known of one solver at one setting in the long run.
struct Course {
  std::map<std::pair<std::string, double>, const LongRunRow*> found;  // by quantity and time
  std::map<std::string, std::string> ended;                           // by scene: why, and when
};

constexpr double watched[] = {0.5, 2, 5, 10};  // s

const Cell nothing{.text = "–", .style = "dim"};

Cell energy_cell(const Course& course, double time) {
  const auto at = course.found.find({"energy", time});
  if (at == course.found.end()) return nothing;
  const LongRunRow& row = *at->second;
  return {.text = show_number(row.value, 4),
          .style = shade(row.value / row.reference - 1, 0.01, 0.1, 0.5)};
}

/// A quantity at the end of a scene, and the differences at which its cell is shaded.
struct EndQuantity {
  const char *name, *scene;
  double slight, strong, extreme;
  int digits;
};
constexpr EndQuantity end_quantities[] = {{"drape", "hanging", 1e-3, 1e-2, 0.1, 2},
                                          {"lowest", "hanging", 1e-3, 1e-2, 0.1, 4},
                                          {"linear_momentum", "free", 1e-10, 1e-4, 1e-2, 2},
                                          {"angular_momentum", "free", 1e-10, 1e-4, 1e-2, 2}};

Cell end_cell(const Course& course, const EndQuantity& quantity) {
  if (const auto at = course.found.find({quantity.name, watched[std::size(watched) - 1]});
      at != course.found.end()) {
    const LongRunRow& row = *at->second;
    return {.text = show_number(row.value, quantity.digits),
            .style = shade(row.value - row.reference, quantity.slight, quantity.strong,
                           quantity.extreme)};
  }
  const auto ended = course.ended.find(quantity.scene);
  return ended == course.ended.end()
             ? nothing
             : Cell{.text = "ended", .style = "dim", .title = ended->second};
}

/// A mark where times were taken on a machine that was disturbed.
template <class Row>
std::string conditions_note(const std::vector<Row>& rows) {
  std::size_t count = 0;
  for (const Row& row : rows)
    count += disturbed(row.conditions.drift, row.conditions.processor_share);
  const std::string when = escape(rows.front().conditions.measured);
  if (count == 0) return fmt::format("<p class=\"dim\">Timed {}, undisturbed.</p>\n", when);
  return fmt::format(
      "<p><span class=\"chip lower\">⚠ disturbed</span> <span class=\"dim\">Timed {}: during {} of "
      "{} rows the machine's speed drifted, or another program had the processor, for more than 5 "
      "%. Take the times with care.</span></p>\n",
      when, count, rows.size());
}

std::string milliseconds(double ns) { return show_number(ns / 1e6, 3) + " ms"; }

Cell wins_cell(const ImplicitWinsRow& ours, const ImplicitWinsRow& row) {
  const double low = ours.wall_ns_min / row.wall_ns_median,
               high = ours.wall_ns_median / row.wall_ns_min;
  return {.text = fmt::format("{:.2g}×, {} m", ours.wall_ns_min / row.wall_ns_min,
                              show_number(row.rk4_distance, 2)),
          .style = low > 1    ? "confirmed"
                   : high < 1 ? "lower"
                              : "undetermined",
          .title = fmt::format("{} against {}, {:.2g} to {:.2g} times; RK4 converged to {:.0e} m",
                               milliseconds(ours.wall_ns_min), milliseconds(row.wall_ns_min), low,
                               high, row.rk4_left)};
}

}  // namespace

std::string long_run_table(const std::vector<LongRunRow>& rows) {
  if (rows.empty()) return {};
  std::vector<std::string> order;
  std::map<std::string, Course> courses;
  std::map<double, double> truth;
  std::string problem;
  for (const LongRunRow& row : rows) {
    const std::string who =
        fmt::format("{}/{}, {}", row.library, row.solver,
                    row.setting_kind == "tol" ? fmt::format("tolerance {:.0e}", row.setting)
                                              : "h = " + show_step(row.setting));
    if (!courses.contains(who)) order.push_back(who);
    Course& course = courses[who];
    if (row.status != "ok") {
      course.ended[row.scene] =
          fmt::format("{} at t = {}: {}", row.status, show_number(row.time), row.detail);
      continue;
    }
    course.found[{row.quantity, row.time}] = &row;
    if (row.quantity == "energy") truth[row.time] = row.reference;
    if (row.quantity == "energy" && !row.detail.empty()) problem = row.detail;
  }
  std::string html =
      "<h3>Ten seconds of a cloth</h3>\n<p>The cloth of 11 x 11 particles, hung along one edge and "
      "thrown, until it hangs at rest: its energy in J as it decays (first line: the reference, on "
      "which two computed references agree to 1e-6 m), and at t = 10 s its drape: the RMS "
      "distance of a particle from the reference, and the lowest point, in m.</p>\n"
      "<p>Momentum is of the same cloth thrown free, without gravity and dampers, for 10 s: the "
      "change of linear and angular momentum over what they were. The exact solution keeps "
      "both.</p>\n";
  if (!problem.empty()) html += "<p class=\"missing\">" + escape(problem) + "</p>\n";
  report::Table table("numbers tolerances");
  std::vector<Cell> head{{"solver"}}, reference;
  for (const double time : watched) {
    head.push_back({fmt::format("E, t = {} s", show_number(time))});
    reference.push_back({show_number(truth[time], 4)});
  }
  head.insert(head.end(), {{"drape"}, {"lowest"}, {"linear momentum"}, {"angular momentum"}});
  table.head(head);
  double lowest = not_measured;
  for (const LongRunRow& row : rows)
    if (row.quantity == "lowest" && row.time == watched[std::size(watched) - 1])
      lowest = row.reference;
  reference.insert(reference.end(), {{"0"}, {show_number(lowest, 4)}, {"0"}, {"0"}});
  table.row({.markup = "<strong>reference</strong>"}, reference);
  for (const std::string& who : order) {
    std::vector<Cell> cells;
    for (const double time : watched) cells.push_back(energy_cell(courses[who], time));
    for (const EndQuantity& quantity : end_quantities)
      cells.push_back(end_cell(courses[who], quantity));
    table.row({who}, cells);
  }
  return html + table.html();
}

std::string cloth_cost_table(const std::vector<ClothCostRow>& rows) {
  if (rows.empty()) return {};
  std::map<std::uint64_t, std::map<std::string, const ClothCostRow*>> by_side;
  std::map<std::string, double> least;
  for (const ClothCostRow& row : rows) {
    by_side[row.side][row.precision] = &row;
    double& best = least.try_emplace(row.precision, row.wall_ns_min).first->second;
    best = std::min(best, row.wall_ns_min);
  }
  report::Table table("numbers tolerances");
  table.head({{"cloth"}, {"particles"}, {"f64"}, {}, {"f32"}, {}});
  for (const auto& [side, columns] : by_side) {
    std::vector<Cell> cells{{std::to_string(side * side)}};
    for (const char* precision : {"f64", "f32"}) {
      const auto at = columns.find(precision);
      if (at == columns.end()) {
        cells.insert(cells.end(), {nothing, {}});
        continue;
      }
      const ClothCostRow& row = *at->second;
      const double more = row.wall_ns_min / least[precision];
      cells.push_back({fmt::format("{:.1f} ns ({:.1f})", row.wall_ns_min, row.wall_ns_median)});
      cells.push_back(
          {.text = fmt::format("{:.2f}×", more), .style = shade(more - 1, 0.1, 0.5, 1)});
    }
    table.row({fmt::format("{0} x {0}", side)}, cells);
  }
  return "<h3>Cost per particle</h3>\n<p>A step of velocity Verlet in "
         "<code>scene::GridCloth</code> on one processor, in ns per particle: minimum, median in "
         "brackets, and the ratio to the cheapest size. Linear cost is a column of 1×; large "
         "cloths "
         "cost more because of memory access.</p>\n" +
         conditions_note(rows) + table.html();
}

std::string implicit_wins_table(const std::vector<ImplicitWinsRow>& rows) {
  if (rows.empty()) return {};
  std::set<double> stiffnesses, frames;
  for (const ImplicitWinsRow& row : rows) {
    stiffnesses.insert(row.stiffness);
    if (!std::isnan(row.frame)) frames.insert(row.frame);
  }
  const auto find = [&](double stiffness, double frame) {
    const ImplicitWinsRow* best = nullptr;
    for (const ImplicitWinsRow& row : rows)
      if (row.stiffness == stiffness && row.status == "ok" &&
          (row.frame == frame || (std::isnan(frame) && std::isnan(row.frame))) &&
          (!best || row.wall_ns_min < best->wall_ns_min))
        best = &row;
    return best;
  };
  report::Table table("numbers tolerances");
  std::vector<Cell> head{{"stiffness"}, {"explicit"}, {"a second takes"}, {"distance"}};
  for (const double frame : frames) head.push_back({"implicit, h = " + show_step(frame)});
  table.head(head);
  for (const double stiffness : stiffnesses) {
    const ImplicitWinsRow* ours = find(stiffness, not_measured);
    std::vector<Cell> cells;
    if (ours)
      cells = {{fmt::format("{}, h = {}", ours->engine, show_step(ours->step))},
               {milliseconds(ours->wall_ns_min)},
               {show_number(ours->rk4_distance, 2) + " m"}};
    else
      cells = {{.text = "none is stable", .style = "dim", .columns = 3}};
    for (const double frame : frames) {
      const ImplicitWinsRow* row = find(stiffness, frame);
      cells.push_back(row && ours ? wins_cell(*ours, *row) : nothing);
    }
    table.row({fmt::format("{:g} N/m", stiffness)}, cells);
  }
  return "<h3>Where implicit is faster</h3>\n<p>A cloth of 32 x 32 by its stiffness: the time that "
         "one simulated second takes the fastest explicit method (velocity Verlet or IMEX in f32, "
         "each at the largest stable step less a tenth) over the time that backward Euler "
         "(predicted_implicit_euler, f64, each system solved to 1 %) takes at a fixed "
         "step: green, above 1, where implicit is faster, orange where it is slower.</p>\n"
         "<p>Beside it, the RMS distance of a particle at t = 0.27 s from a run of RK4 in f64 at "
         "half the stable step, in m: there is no independent truth at this size. The cloth is 1 m "
         "wide: an implicit step that is stable may be inaccurate; at 0.1 m the shape is no longer "
         "that of the cloth.</p>\n" +
         conditions_note(rows) + table.html();
}

}  // namespace odeum::study
