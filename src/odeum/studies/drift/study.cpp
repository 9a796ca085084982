// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <nlohmann/json.hpp>

#include "odeum/proof/facts.hpp"
#include "odeum/proof/structure_check.hpp"
#include "odeum/report/report.hpp"
#include "odeum/studies/drift/drift.hpp"

namespace odeum::study {
namespace {

/// A series of drift.csv in one line.
struct DriftSummary {
  DriftRow last;
  double worst = nan, latest = nan;

  ODEUM_COLUMNS(last, worst, latest)
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

std::string table(const DriftResult& result) {
  const std::string horizons = record::tables_of(result);
  return record::table_of(summarise(result.rows),
                          "case solver invariant time worst:.2e latest:.2e status")
             .text() +
         (horizons.empty() ? "" : "\n" + horizons);
}

/// Finds the own solvers that keep the symplectic form, by runs, for the diagram of energies.
void show_symplectic(report::Report& report, const DriftResult&) {
  nlohmann::ordered_json ids = nlohmann::ordered_json::array();
  for (const proof::MethodFacts& method : proof::all_method_facts())
    if (const auto mechanics = method.on_mechanics();
        mechanics &&
        proof::symplectic_defect(mechanics, proof::structure_step) <= proof::symplectic_rounding)
      ids.push_back("odeum/" + method.id());
  report.fact("symplectic", ids);
}

}  // namespace

// A report runs own solvers on every case; peers on an orbit, an oscillator and, for its horizon, a
// chaotic case, without arkode, whose many tables would take as long as all the rest.
std::unique_ptr<Study> make_drift() {
  return make_study<DriftResult>(
      {.name = "drift",
       .help = "the errors of energy and invariants after a long time",
       .place = 60,
       .figures = {{"steps", drift_steps},
                   {"steps_of_large", drift_steps_of_large},
                   {"most_unknowns", drift_most_unknowns}},
       .report = {{.solvers = {"odeum/*"}},
                  {.cases = {"kepler_e06", "osc_undamped"}, .solvers = {"!odeum/*"}},
                  {.cases = {"lorenz_kehlet_logg"}, .solvers = {"!odeum/*", "!arkode/*"}}}},
      {.measure = measure_drift, .table = table, .show_more = show_symplectic});
}

}  // namespace odeum::study
