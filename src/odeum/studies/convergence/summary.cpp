// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/summary.hpp"

#include "odeum/record/table.hpp"
#include "odeum/report/text.hpp"

namespace odeum::study {

std::vector<LibrarySummary> summarise(const report::Facts& facts,
                                      const std::vector<OrderRow>& orders) {
  std::vector<LibrarySummary> list;
  for (const std::string& name : facts.library_names()) list.push_back({.library = name});
  LibrarySummary all{.library = "all"};
  const auto count = [&](const std::string& library, auto&& add) {
    for (LibrarySummary& entry : list)
      if (entry.library == library) add(entry);
    add(all);
  };
  for (const SolverInfo& solver : facts.solvers)
    count(solver.library, [](LibrarySummary& entry) { ++entry.solvers; });
  for (const OrderRow& row : orders)
    count(row.library, [&](LibrarySummary& entry) {
      ++entry.pairs;
      ++entry.verdicts[static_cast<std::size_t>(row.fit.verdict)];
    });
  list.push_back(all);
  return list;
}

std::string summary_text(const report::Facts& facts, const std::vector<OrderRow>& orders) {
  record::Table table{{{"library"}, {"solvers", true}, {"pairs", true}}, {}};
  for (std::size_t i = 0; i < LibrarySummary().verdicts.size(); ++i)
    table.columns.push_back({to_string(static_cast<judge::Verdict>(i)), true});
  for (const LibrarySummary& entry : summarise(facts, orders)) {
    std::vector<std::string> row{report::plain(entry.library), std::to_string(entry.solvers),
                                 std::to_string(entry.pairs)};
    for (const std::size_t count : entry.verdicts) row.push_back(std::to_string(count));
    table.rows.push_back(std::move(row));
  }
  return table.text();
}

}  // namespace odeum::study
