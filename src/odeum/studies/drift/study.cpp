// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "odeum/record/table.hpp"
#include "odeum/studies/drift/drift.hpp"
#include "odeum/studies/drift/section.hpp"

namespace odeum::study {
namespace {

/// A series of drift.csv in one line.
struct DriftSummary {
  DriftRow last;
  double worst = DriftRow::nan, latest = DriftRow::nan;

  static void each(auto& row, auto&& visit) {
    DriftRow::each(row.last, visit);
    visit("worst", row.worst), visit("latest", row.latest);
  }
  bool continues_with(const DriftRow& row) const {
    return row.case_id == last.case_id && row.library == last.library &&
           row.solver == last.solver && row.invariant == last.invariant;
  }
};

std::vector<DriftSummary> summarise(const std::vector<DriftRow>& rows) {
  std::vector<DriftSummary> lines;
  for (const DriftRow& row : rows) {
    if (lines.empty() || !lines.back().continues_with(row)) lines.emplace_back();
    DriftSummary& line = lines.back();
    line.last = row;
    line.worst = std::fmax(line.worst, row.relative_error);
    if (!std::isnan(row.relative_error)) line.latest = row.relative_error;
  }
  return lines;
}

class Drift final : public StudyOf<DriftResult> {
 public:
  Drift()
      : StudyOf({.name = "drift",
                 .help = "the errors of energy and invariants after a long time",
                 .place = 60}) {}

  /// Own solvers on every case; peers on an orbit, an oscillator and, for its horizon, a chaotic
  /// case, without arkode, whose many tables would take as long as all the rest.
  std::vector<Options> report_runs(bool quick) const override {
    if (quick) return {};
    return {{.solvers = {"odeum/*"}},
            {.cases = {"kepler_e06", "osc_undamped"}, .solvers = {"!odeum/*"}},
            {.cases = {"lorenz_kehlet_logg"}, .solvers = {"!odeum/*", "!arkode/*"}}};
  }

  std::string table() const override {
    std::string text =
        record::table_of(summarise(result().rows), {{"case", "{case}"},
                                                    {"solver", "{library}/{solver}"},
                                                    {"invariant", "{invariant}"},
                                                    {"to time", "{time:.4g}"},
                                                    {"worst", "{worst:.2e}"},
                                                    {"last", "{latest:.2e}"},
                                                    {"status", "{status}: {detail}"}})
            .text();
    if (!result().horizons.empty())
      text += '\n' + record::table_of(result().horizons, {{"case", "{case}"},
                                                          {"solver", "{library}/{solver}"},
                                                          {"mode", "{mode}"},
                                                          {"setting", "{setting:.2g}"},
                                                          {"1e-3 at", "{horizon:.2f}"},
                                                          {"status", "{status}: {detail}"}})
                         .text();
    return text;
  }

  void section(report::Page& page) const override { add_section(page, result(), origin()); }

 protected:
  DriftResult run(const Options& options, const Runner& runner) const override {
    return measure_drift(options, runner);
  }
};

}  // namespace

std::unique_ptr<Study> make_drift() { return std::make_unique<Drift>(); }

}  // namespace odeum::study
