// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "odeum/report/earlier_csv.hpp"
#include "odeum/study/hard_cases.hpp"

namespace odeum::study {
namespace {

using report::CsvReader;

template <class Row>
void read_names(const CsvReader& csv, Row& row) {
  row.library = csv.text("library");
  row.solver = csv.text("solver");
}

template <class Row>
void read_case(const CsvReader& csv, Row& row) {
  row.case_id = csv.text("case");
  row.status = csv.text("status");
  row.detail = csv.text("detail");
  read_names(csv, row);
}

DriftRow drift_row(const CsvReader& csv) {
  DriftRow row;
  read_case(csv, row);
  row.step = csv.number("step").value();
  row.time = csv.number("time").value();
  row.invariant = csv.text("invariant");
  row.relative_error = csv.number("relative_error").value();
  row.value = csv.number("value").value();
  return row;
}

HorizonRow horizon_row(const CsvReader& csv) {
  HorizonRow row;
  read_case(csv, row);
  row.mode = csv.text("mode") == to_string(Mode::adaptive) ? Mode::adaptive : Mode::fixed;
  row.setting = csv.number("setting").value();
  row.horizon = csv.number("horizon").value();
  return row;
}

LargestStep largest_step(const CsvReader& csv) {
  LargestStep row;
  read_case(csv, row);
  row.largest_stable_step = csv.number("largest_stable_step").value();
  row.predicted_step = csv.number("predicted_step").value();
  row.eigenvalue = {csv.number("eigenvalue_re").value(), csv.number("eigenvalue_im").value()};
  row.window = csv.number("window").value();
  return row;
}

ReductionRow reduction_row(const CsvReader& csv) {
  constexpr std::array verdicts{Verdict::confirmed,     Verdict::higher,       Verdict::lower,
                                Verdict::floors,        Verdict::undetermined, Verdict::failed,
                                Verdict::not_applicable};
  ReductionRow row;
  read_names(csv, row);
  row.lambda = csv.number("lambda").value();
  row.claimed_order = csv.number("claimed_order").value();
  row.error_finest = csv.number("error_finest").value();
  row.fit.order = csv.number("measured_order").value();
  row.fit.low = csv.number("order_low").value();
  row.fit.high = csv.number("order_high").value();
  row.fit.points =
      static_cast<std::size_t>(std::min(1e6, std::max(0.0, csv.number("points").value())));
  row.fit.reason = csv.text("reason");
  const auto* const verdict = std::find_if(verdicts.begin(), verdicts.end(), [&](Verdict each) {
    return csv.text("verdict") == to_string(each);
  });
  if (verdict == verdicts.end()) throw std::bad_optional_access();
  row.fit.verdict = *verdict;
  return row;
}

template <class Row>
std::vector<Row> taken(report::EarlierRows<Row> earlier, std::string& problem) {
  if (!earlier.problem.empty()) problem += (problem.empty() ? "" : "; ") + earlier.problem;
  return std::move(earlier.rows);
}

/// A case, or none, and a solver.
using Pair = std::pair<std::string, std::string>;

template <class Row>
Pair pair_of(const Row& row) {
  return {row.case_id, row.library + "/" + row.solver};
}
Pair pair_of(const ReductionRow& row) { return {"", row.library + "/" + row.solver}; }

template <class Row>
void add_others(std::vector<Row>& rows, std::vector<Row> earlier, const std::set<Pair>& known) {
  std::set<Pair> measured;
  for (const Row& row : rows) measured.insert(pair_of(row));
  for (Row& row : earlier)
    if (const Pair pair = pair_of(row); known.contains(pair) && !measured.contains(pair))
      rows.push_back(std::move(row));
}

}  // namespace

HardCaseResults read_hard_cases(const std::filesystem::path& folder) {
  using report::read_earlier;
  HardCaseResults all;
  all.drift.rows =
      taken(read_earlier<DriftRow>(folder, "drift.csv",
                                   {"case", "library", "solver", "status", "step", "time",
                                    "invariant", "relative_error", "value", "detail"},
                                   drift_row),
            all.problem);
  all.drift.horizons = taken(read_earlier<HorizonRow>(folder, "horizons.csv",
                                                      {"case", "library", "solver", "status",
                                                       "detail", "mode", "setting", "horizon"},
                                                      horizon_row),
                             all.problem);
  all.largest_steps =
      taken(read_earlier<LargestStep>(
                folder, "largest_steps.csv",
                {"case", "library", "solver", "status", "detail", "largest_stable_step",
                 "predicted_step", "eigenvalue_re", "eigenvalue_im", "window"},
                largest_step),
            all.problem);
  all.reduction = taken(read_earlier<ReductionRow>(folder, "order_reduction.csv",
                                                   {"library", "solver", "lambda", "claimed_order",
                                                    "measured_order", "error_finest", "order_low",
                                                    "order_high", "points", "verdict", "reason"},
                                                   reduction_row),
                        all.problem);
  return all;
}

void add_earlier(HardCaseResults& result, HardCaseResults earlier, const std::vector<Case>& cases) {
  std::set<Pair> known;
  for (const Case& c : cases)
    for (const Entrant& entrant : c.entrants) {
      known.insert({c.id, entrant.info.id()});
      known.insert({"", entrant.info.id()});
    }
  add_others(result.drift.rows, std::move(earlier.drift.rows), known);
  add_others(result.drift.horizons, std::move(earlier.drift.horizons), known);
  add_others(result.largest_steps, std::move(earlier.largest_steps), known);
  add_others(result.reduction, std::move(earlier.reduction), known);
  result.problem = std::move(earlier.problem);
}

void write_csv(const HardCaseResults& result, const report::OutputFolder& folder) {
  write_csv(result.drift, folder);
  write_csv(result.largest_steps, folder);
  write_csv(result.reduction, folder);
}

}  // namespace odeum::study
