// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/studies/hard_cases/section.hpp"

namespace odeum::report {
namespace {

using study::DriftRow;
using study::HorizonRow;

constexpr const char* oscillator = "osc_undamped";

/// First and last of one quantity of a run that ended `ok`; null where it did not.
struct Ends {
  const DriftRow *first = nullptr, *last = nullptr;
};

Ends ends_of(const std::vector<const DriftRow*>& rows, const std::string& quantity) {
  Ends ends;
  for (const DriftRow* row : rows) {
    if (row->invariant != quantity) continue;
    if (row->status != to_string(Status::ok)) return {};
    if (!ends.first) ends.first = row;
    ends.last = row;
  }
  return ends;
}

// Blue: as good as exact; orange: nothing left.
std::string colour_of(double error) {
  if (error <= 1e-9) return "t-2";
  if (error <= 1e-5) return "t-1";
  return error <= 1e-2 ? "" : error <= 0.5 ? "t1" : error <= 1 ? "t2" : "t3";
}

std::string number_cell(double error, double shown, const char* format) {
  return fmt::format("<td class=\"{}\">{}</td>", colour_of(std::abs(error)),
                     fmt::format(fmt::runtime(format), shown));
}

std::string oscillator_cells(const std::vector<const DriftRow*>& rows) {
  const Ends energy = ends_of(rows, "energy"), amplitude = ends_of(rows, "amplitude"),
             phase = ends_of(rows, "phase");
  if (!energy.last || !amplitude.last || !phase.last)
    return fmt::format("<td colspan=\"4\" class=\"dim\">{}</td>", escape(rows.back()->status));
  // The row has the size of the change; which way it went shows from the first value to the last.
  const double change =
      std::copysign(amplitude.last->relative_error, amplitude.last->value - amplitude.first->value);
  return number_cell(change, change, "{:+.1e}") +
         number_cell(phase.last->value, phase.last->value, "{:+.1e}") +
         number_cell(phase.last->relative_error, phase.last->relative_error, "{:.1e}") +
         number_cell(energy.last->relative_error, energy.last->relative_error, "{:.1e}");
}

/// A setting of the study, those at a fixed step first, from coarse to fine.
struct Setting {
  Mode mode;
  double value;
  bool operator<(const Setting& other) const {
    return mode != other.mode ? mode == Mode::fixed : value > other.value;
  }
};

std::string horizon_cell(const HorizonRow& row, double longest) {
  if (std::isnan(row.horizon))
    return fmt::format("<td class=\"{}\" title=\"{}\">{}</td>",
                       row.status == to_string(Status::ok) ? "confirmed" : "dim",
                       escape(row.status + (row.detail.empty() ? "" : ": " + row.detail)),
                       row.status == to_string(Status::ok) ? "beyond" : "✗");
  const double share = row.horizon / longest;
  const char* colour = share > 0.8    ? "t-3"
                       : share > 0.6  ? "t-2"
                       : share > 0.4  ? "t-1"
                       : share > 0.2  ? ""
                       : share > 0.05 ? "t1"
                                      : "t2";
  return fmt::format("<td class=\"{}\">{:.1f}</td>", colour, row.horizon);
}

}  // namespace

std::string oscillator_part(const PageContext& page) {
  const auto solvers = by_solver(page.data.hard_cases.drift.rows, [](const DriftRow& row) {
    return row.case_id == oscillator && row.status != "not_applicable";
  });
  if (solvers.empty()) return {};
  const std::string tables = solver_tables(
      page, "numbers drifts",
      "<th>amplitude</th><th>phase, rad</th><th>frequency</th><th>energy</th>",
      [&](const SolverInfo& solver) {
        const auto found = solvers.find(solver.id());
        return found == solvers.end() ? std::string() : oscillator_cells(found->second);
      });
  const DriftRow& any = *solvers.begin()->second.front();
  return fmt::format(
             "<h3 id=\"oscillator\">Amplitude, phase and energy</h3>\n<p>What ten thousand steps "
             "of "
             "{} do to <code>{}</code>, taken apart: the amplitude as a change from the exact one "
             "(+ grows, − dies away), how far the solution lags behind in radians (− runs ahead), "
             "the relative error of the frequency that this comes to, and that of the energy. A "
             "method can keep the energy and be out of phase by turns. Errors of the last "
             "step.</p>\n",
             show_number(any.step), oscillator) +
         tables;
}

std::string horizons_part(const PageContext& page) {
  std::set<Setting> settings;
  const auto solvers = by_solver(page.data.hard_cases.drift.horizons, [](const HorizonRow& row) {
    return row.case_id == study::horizon_case && row.status != "not_applicable";
  });
  if (solvers.empty()) return {};
  double longest = 0;
  for (const auto& [solver, rows] : solvers)
    for (const HorizonRow* row : rows) {
      settings.insert({row->mode, row->setting});
      longest = std::fmax(longest, row->horizon);
    }
  std::string head;
  for (const Setting& setting : settings)
    head += fmt::format("<th>{} {}</th>", setting.mode == Mode::fixed ? "h =" : "tol",
                        show_number(setting.value, 3));
  const std::string tables =
      solver_tables(page, "numbers drifts", head, [&](const SolverInfo& solver) {
        const auto found = solvers.find(solver.id());
        if (found == solvers.end()) return std::string();
        std::string html;
        for (const Setting& setting : settings) {
          const auto row =
              std::find_if(found->second.begin(), found->second.end(), [&](const auto* each) {
                return each->mode == setting.mode && each->setting == setting.value;
              });
          html += row == found->second.end() ? "<td class=\"zero\">·</td>"
                                             : horizon_cell(**row, longest);
        }
        return html;
      });
  return fmt::format(
             "<h3 id=\"horizons\">How far chaos can be followed</h3>\n<p>When the largest error on "
             "<code>{}</code> reaches 10<sup>−3</sup>, at three steps and three tolerances. Errors "
             "grow by a factor of e each 1.1 units of time whatever the method, so that ten times "
             "the accuracy buys a fixed number of units more: a column is worth comparing, a small "
             "difference in it is not. ✗: the run ended before; 0.5 is the first time at which the "
             "truth is compared.</p>\n",
             study::horizon_case) +
         tables;
}

}  // namespace odeum::report
