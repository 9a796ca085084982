// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <nlohmann/json.hpp>

#include "odeum/report/columns.hpp"
#include "odeum/studies/precision/section.hpp"
#include "odeum/studies/questions.hpp"

namespace odeum::study {

void add_answers(report::Page& page, const PrecisionResult& result) {
  nlohmann::ordered_json asked = nlohmann::ordered_json::array();
  for (const Question& question : questions)
    asked.push_back({{"title", question.title}, {"case", question.case_id}});
  page.data("index", "questions", asked.dump());
  std::vector<FastestRow> best;
  for (std::size_t i = 0; i < page.facts().cases.size(); ++i) {
    const report::CaseFacts& c = page.facts().cases[i];
    std::vector<PrecisionRow> rows;
    for (const PrecisionRow& row : result.rows)
      if (row.case_id == c.id) rows.push_back(row);
    if (rows.empty()) continue;
    std::vector<const PrecisionRow*> pointers;
    for (const PrecisionRow& row : rows) pointers.push_back(&row);
    page.case_data(i, "timed",
                   report::columns_of(
                       pointers, {"library", "solver", "setting_kind", "status", "detail",
                                  "setting", "options", "error", "wall_ns_min", "wall_ns_median",
                                  "repetitions", "rhs_evaluations", "jacobian_evaluations", "steps",
                                  "pareto", "drift", "processor_share", "measured"}));
    // From the rows, which may be of an earlier run that left no fastest.csv.
    const std::vector<FastestRow> of_case = fastest(rows, c.timed_floor);
    best.insert(best.end(), of_case.begin(), of_case.end());
  }
  std::vector<const FastestRow*> pointers;
  for (const FastestRow& row : best) pointers.push_back(&row);
  page.data("index", "fastest",
            report::columns_of(pointers, {"case", "error", "library", "solver", "setting_kind",
                                          "setting", "wall_ns_min", "wall_ns_median"}));
}

}  // namespace odeum::study
