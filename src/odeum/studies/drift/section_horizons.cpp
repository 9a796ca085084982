// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/solver_tables.hpp"
#include "odeum/studies/drift/section.hpp"

namespace odeum::study {
namespace {

using report::Cell;
using report::show_number;

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
std::string colour_of_horizon(double error) {
  if (error <= 1e-9) return "t-2";
  if (error <= 1e-5) return "t-1";
  return error <= 1e-2 ? "" : error <= 0.5 ? "t1" : error <= 1 ? "t2" : "t3";
}

Cell number_cell(double error, const char* format) {
  return {.text = fmt::format(fmt::runtime(format), error), .style = colour_of_horizon(std::abs(error))};
}

std::vector<Cell> oscillator_cells(const std::vector<const DriftRow*>& rows) {
  const Ends energy = ends_of(rows, "energy"), amplitude = ends_of(rows, "amplitude"),
             phase = ends_of(rows, "phase");
  if (!energy.last || !amplitude.last || !phase.last)
    return {{.text = rows.back()->status, .style = "dim", .columns = 4}};
  // The row has the magnitude of the change; its sign follows from the first and the last value.
  const double change =
      std::copysign(amplitude.last->relative_error, amplitude.last->value - amplitude.first->value);
  return {number_cell(change, "{:+.1e}"), number_cell(phase.last->value, "{:+.1e}"),
          number_cell(phase.last->relative_error, "{:.1e}"),
          number_cell(energy.last->relative_error, "{:.1e}")};
}

/// A setting of the study, those at a fixed step first, from coarse to fine.
struct Setting {
  Mode mode;
  double value;
  bool operator<(const Setting& other) const {
    return mode != other.mode ? mode == Mode::fixed : value > other.value;
  }
};

Cell horizon_cell(const HorizonRow& row, double longest) {
  const bool ok = row.status == to_string(Status::ok);
  if (std::isnan(row.horizon))
    return {.text = ok ? "beyond" : "✗",
            .style = ok ? "confirmed" : "dim",
            .title = row.status + (row.detail.empty() ? "" : ": " + row.detail)};
  const double share = row.horizon / longest;
  return {.text = fmt::format("{:.1f}", row.horizon),
          .style = share > 0.8    ? "t-3"
                   : share > 0.6  ? "t-2"
                   : share > 0.4  ? "t-1"
                   : share > 0.2  ? ""
                   : share > 0.05 ? "t1"
                                  : "t2"};
}

}  // namespace

std::string oscillator_part(const report::Facts& facts, const std::vector<DriftRow>& rows) {
  const auto solvers = report::by_solver(rows, [](const DriftRow& row) {
    return row.case_id == oscillator && row.status != "not_applicable";
  });
  if (solvers.empty()) return {};
  return fmt::format(
             "<h3 id=\"oscillator\">Amplitude, phase and energy</h3>\n<p>Errors of <code>{}</code> "
             "after ten thousand steps of {}: the relative change of the amplitude (+ grows, − "
             "decays), the lag of the phase in radians (− is ahead), the relative error of the "
             "frequency that follows from it, and that of the energy. A method can conserve the "
             "energy and be several turns out of phase.</p>\n",
             oscillator, show_number(solvers.begin()->second.front()->step)) +
         report::solver_tables(facts, "numbers drifts",
                               {{"amplitude"}, {"phase, rad"}, {"frequency"}, {"energy"}}, solvers,
                               oscillator_cells);
}

std::string horizons_part(const report::Facts& facts, const std::vector<HorizonRow>& rows) {
  const auto solvers =
      report::by_solver(rows, [](const HorizonRow& row) { return row.status != "not_applicable"; });
  if (solvers.empty()) return {};
  std::set<Setting> settings;
  double longest = 0;
  for (const auto& [solver, own] : solvers)
    for (const HorizonRow* row : own) {
      settings.insert({row->mode, row->setting});
      longest = std::fmax(longest, row->horizon);
    }
  std::vector<Cell> head;
  for (const Setting& setting : settings)
    head.push_back({fmt::format("{} {}", setting.mode == Mode::fixed ? "h =" : "tol",
                                show_number(setting.value, 3))});
  const auto cells = [&](const std::vector<const HorizonRow*>& own) {
    return report::cells_by_column(
        own, settings,
        [](const HorizonRow& row, const Setting& setting) {
          return row.mode == setting.mode && row.setting == setting.value;
        },
        [&](const HorizonRow& row) { return horizon_cell(row, longest); },
        {.text = "·", .style = "zero"});
  };
  return fmt::format(
             "<h3 id=\"horizons\">How long a chaotic solution can be followed</h3>\n<p>The time at "
             "which the largest error on <code>{}</code> reaches 10<sup>−3</sup>, at three steps "
             "and "
             "three tolerances. Errors grow by a factor of e each 1.1 units of time whatever the "
             "method, so that ten times the accuracy adds a fixed number of units: compare "
             "columns, "
             "not small differences. ✗: the run ended before; 0.5 is the first time at which the "
             "reference is compared.</p>\n",
             report::escape(solvers.begin()->second.front()->case_id)) +
         report::solver_tables(facts, "numbers drifts", head, solvers, cells);
}

}  // namespace odeum::study
