// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/studies/material/section.hpp"
#include "odeum/studies/precision/speed_diagram.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::report {
namespace {

using study::ClothCostRow;
using study::ImplicitWinsRow;
using study::LongRunRow;

/// What is known of one solver at one setting in the long run.
struct Course {
  std::map<std::pair<std::string, double>, const LongRunRow*> found;  // by quantity and time
  std::map<std::string, std::string> ended;                           // by scene: why, and when
};

constexpr double watched[] = {0.5, 2, 5, 10};  // s

std::string energy_cell(const Course& course, double time) {
  const auto at = course.found.find({"energy", time});
  if (at == course.found.end()) return "<td class=\"dim\">–</td>";
  const LongRunRow& row = *at->second;
  const double off = row.value / row.reference - 1;
  return fmt::format(R"(<td class="{}">{}</td>)", shade(off, 0.01, 0.1, 0.5),
                     show_number(row.value, 4));
}

std::string ended_or(const Course& course, const char* scene) {
  const auto found = course.ended.find(scene);
  return found == course.ended.end()
             ? "<td class=\"dim\">–</td>"
             : fmt::format(R"(<td class="dim" title="{}">ended</td>)", escape(found->second));
}

std::string number_cell(const Course& course, const char* quantity, const char* scene,
                        double slight, double strong, double extreme, int digits) {
  const auto at = course.found.find({quantity, 10.0});
  if (at == course.found.end()) return ended_or(course, scene);
  const LongRunRow& row = *at->second;
  return fmt::format(R"(<td class="{}">{}</td>)",
                     shade(row.value - row.reference, slight, strong, extreme),
                     show_number(row.value, digits));
}

/// A mark where times were taken on a machine that was disturbed.
template <class Row>
std::string conditions_note(const std::vector<Row>& rows) {
  std::size_t count = 0;
  for (const Row& row : rows)
    if (study::disturbed(row.conditions.drift, row.conditions.processor_share)) ++count;
  const std::string when = escape(rows.front().conditions.measured);
  if (count == 0) return fmt::format("<p class=\"dim\">Timed {}, undisturbed.</p>\n", when);
  return fmt::format(
      "<p><span class=\"chip lower\">⚠ disturbed</span> <span class=\"dim\">Timed {}: during {} of "
      "{} rows the machine's speed drifted, or another program had the processor, for more than 5 "
      "%. Take the times with care.</span></p>\n",
      when, count, rows.size());
}

std::string milliseconds(double ns) { return show_number(ns / 1e6, 3) + " ms"; }

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
      "which two own methods of high order agree to 1e-6 m), and at t = 10 s its drape: the RMS "
      "distance of a particle from the reference, and the lowest point, in m.</p>\n"
      "<p>Momentum is of the same cloth thrown free, without gravity and dampers, for 10 s: the "
      "change of linear and angular momentum over what they were. The exact solution keeps "
      "both.</p>\n";
  if (!problem.empty()) html += "<p class=\"missing\">" + escape(problem) + "</p>\n";
  html += R"(<div class="wide"><table class="numbers tolerances"><thead><tr><th>solver</th>)";
  for (const double time : watched) html += fmt::format("<th>E, t = {} s</th>", show_number(time));
  html +=
      "<th>drape</th><th>lowest</th><th>linear momentum</th><th>angular "
      "momentum</th></tr></thead><tbody>\n<tr><th><strong>reference</strong></th>";
  for (const double time : watched) html += fmt::format("<td>{}</td>", show_number(truth[time], 4));
  double lowest = study::not_measured;
  for (const LongRunRow& row : rows)
    if (row.quantity == "lowest" && row.time == 10) lowest = row.reference;
  html += fmt::format("<td>0</td><td>{}</td><td>0</td><td>0</td></tr>\n", show_number(lowest, 4));
  for (const std::string& who : order) {
    const Course& course = courses[who];
    html += "<tr><th>" + escape(who) + "</th>";
    for (const double time : watched) html += energy_cell(course, time);
    html += number_cell(course, "drape", "hanging", 1e-3, 1e-2, 0.1, 2) +
            number_cell(course, "lowest", "hanging", 1e-3, 1e-2, 0.1, 4) +
            number_cell(course, "linear_momentum", "free", 1e-10, 1e-4, 1e-2, 2) +
            number_cell(course, "angular_momentum", "free", 1e-10, 1e-4, 1e-2, 2) + "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
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
  std::string html =
      "<h3>Cost a particle</h3>\n<p>A step of velocity Verlet on <code>scene::GridCloth</code> on "
      "one processor, in ns a particle: least time, median in brackets, and how many times the "
      "cheapest size it is. Linear cost, the goal, is a column of 1×; what a large cloth costs "
      "more "
      "is memory.</p>\n" +
      conditions_note(rows) +
      "<div class=\"wide\"><table class=\"numbers tolerances\"><thead><tr><th>cloth</th><th>"
      "particles</th><th>f64</th><th></th><th>f32</th><th></th></tr></thead><tbody>\n";
  for (const auto& [side, columns] : by_side) {
    html += fmt::format("<tr><th>{0} x {0}</th><td>{1}</td>", side, side * side);
    for (const char* precision : {"f64", "f32"}) {
      const auto at = columns.find(precision);
      if (at == columns.end()) {
        html += "<td class=\"dim\">–</td><td></td>";
        continue;
      }
      const ClothCostRow& row = *at->second;
      const double more = row.wall_ns_min / least[precision];
      html += fmt::format("<td>{:.1f} ns ({:.1f})</td><td class=\"{}\">{:.2f}×</td>",
                          row.wall_ns_min, row.wall_ns_median, shade(more - 1, 0.1, 0.5, 1), more);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
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
  std::string html =
      "<h3>Where implicit wins</h3>\n<p>A cloth of 32 x 32 by its stiffness: the time that one "
      "simulated second takes the fastest explicit method (velocity Verlet or IMEX in f32, each at "
      "the largest step that is stable, less a tenth) over the time that backward Euler "
      "(predicted_implicit_euler, f64, each system solved to 1 %) takes at a fixed step: "
      "green, above 1, where implicit is faster, orange where it is slower.</p>\n"
      "<p>Beside it, the RMS distance of a particle at t = 0.27 s from a run of RK4 in f64 at half "
      "the stable step, in m: there is no independent truth at this size. "
      "The cloth is 1 m wide: an implicit step that is stable may be far off, and 0.1 m is a "
      "cloth of another shape.</p>\n" +
      conditions_note(rows) +
      "<div class=\"wide\"><table class=\"numbers tolerances\"><thead><tr><th>stiffness</th><th>"
      "explicit</th><th>a second takes</th><th>distance</th>";
  for (const double frame : frames) html += "<th>implicit, h = " + show_step(frame) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const double stiffness : stiffnesses) {
    html += fmt::format("<tr><th>{:g} N/m</th>", stiffness);
    const ImplicitWinsRow* ours = find(stiffness, study::not_measured);
    html += ours ? fmt::format("<td>{}, h = {}</td><td>{}</td><td>{} m</td>", escape(ours->engine),
                               show_step(ours->step), milliseconds(ours->wall_ns_min),
                               show_number(ours->rk4_distance, 2))
                 : R"(<td class="dim" colspan="3">none is stable</td>)";
    for (const double frame : frames) {
      const ImplicitWinsRow* row = find(stiffness, frame);
      if (!row || !ours) {
        html += "<td class=\"dim\">–</td>";
        continue;
      }
      const double low = ours->wall_ns_min / row->wall_ns_median,
                   high = ours->wall_ns_median / row->wall_ns_min;
      html += fmt::format(
          "<td class=\"{}\" title=\"{} against {}, {:.2g} to {:.2g} times; RK4 converged to {:.0e} "
          "m\">{:.2g}×, {} m</td>",
          low > 1    ? "confirmed"
          : high < 1 ? "lower"
                     : "undetermined",
          milliseconds(ours->wall_ns_min), milliseconds(row->wall_ns_min), low, high, row->rk4_left,
          ours->wall_ns_min / row->wall_ns_min, show_number(row->rk4_distance, 2));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace odeum::report
