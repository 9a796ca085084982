// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "odeum/studies/precision/precision.hpp"

namespace odeum::study {
namespace {

constexpr const char* columns[] = {
    "case",         "library",         "solver",      "status",          "detail",
    "setting_kind", "right_hand_side", "measured",    "setting",         "error",
    "wall_ns_min",  "wall_ns_median",  "repetitions", "rhs_evaluations", "jacobian_evaluations",
    "steps",        "rejected_steps",  "pareto",      "drift",           "processor_share"};

// The row that the reader stands at. Throws std::bad_optional_access where a number is none.
PrecisionRow row_of(const record::CsvReader& csv) {
  const auto number = [&](const char* column) { return csv.number(column).value(); };
  const auto count = [&](const char* column) {
    return static_cast<std::uint64_t>(std::max(0.0, number(column)));
  };
  PrecisionRow row;
  row.case_id = csv.text("case");
  row.library = csv.text("library");
  row.solver = csv.text("solver");
  row.status = csv.text("status");
  row.detail = csv.text("detail");
  row.mode = csv.text("setting_kind") == "tol" ? Mode::adaptive : Mode::fixed;
  row.setting = number("setting");
  row.error = number("error");
  row.wall_ns_min = number("wall_ns_min");
  row.wall_ns_median = number("wall_ns_median");
  row.repetitions = count("repetitions");
  row.counters.rhs_evaluations = count("rhs_evaluations");
  row.counters.jacobian_evaluations = count("jacobian_evaluations");
  row.counters.steps = count("steps");
  row.counters.rejected_steps = count("rejected_steps");
  row.inlined = csv.text("right_hand_side") == "inlined";
  row.pareto = number("pareto") != 0;
  row.drift = number("drift");
  row.processor_share = number("processor_share");
  row.measured = csv.text("measured");
  return row;
}

}  // namespace

EarlierPrecision read_precision_csv(const std::filesystem::path& file) {
  return record::read_earlier<PrecisionRow>(file.parent_path(), file.filename().string(),
                                            {std::begin(columns), std::end(columns)}, row_of);
}

void add_earlier(PrecisionResult& result, const std::vector<PrecisionRow>& earlier,
                 const std::vector<Case>& cases) {
  std::set<std::string> measured;
  for (const PrecisionRow& row : result.rows) measured.insert(row.case_id);
  std::map<std::string, std::vector<PrecisionRow>> by_case;
  for (const PrecisionRow& row : earlier) by_case[row.case_id].push_back(row);
  for (const Case& c : cases) {
    const auto found = by_case.find(c.id);
    if (found == by_case.end() || measured.contains(c.id)) continue;
    const double floor = c.timed_floor();
    for (PrecisionSummary& line : summarise(found->second, floor))
      result.summary.push_back(std::move(line));
    std::move(found->second.begin(), found->second.end(), std::back_inserter(result.rows));
  }
}

}  // namespace odeum::study
