// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "odeum/report/report.hpp"
#include "odeum/report/text.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/convergence/order_reason.hpp"
#include "odeum/studies/questions.hpp"

namespace odeum::study {
namespace {

std::string table(const ConvergenceResult& result) {
  std::map<std::string, std::size_t> wrong;  // by solver and case
  std::size_t all = 0;
  for (const ConvergenceRow& row : result.rows) {
    if (row.judged.answer != judge::Answer::wrong) continue;
    ++wrong[fmt::format("{}/{} on {}", row.library, row.solver, row.case_id)];
    ++all;
  }
  std::string text = record::tables_of(result);
  if (all == 0) return text;
  constexpr std::size_t most = 8;
  text += fmt::format("{} {} ok with a wrong answer, column answer of {}:\n", all,
                      all == 1 ? "run ended" : "runs ended", ConvergenceRow::file);
  std::size_t named = 0;
  for (const auto& [pair, count] : wrong)
    if (named++ < most) text += fmt::format("  {} of {}\n", count, pair);
  return named <= most ? text : text + fmt::format("  and of {} more\n", named - most);
}

/// What a reason for a missing order means, the errors over time of the cloths alone (those of all
/// cases are as large as all other data), and the counts of verdicts.
void show_more(report::Report& report, const ConvergenceResult& result) {
  nlohmann::ordered_json classes = nlohmann::ordered_json::object();
  for (const OrderClass& each : order_classes())
    classes[to_string(each.why)] = {{"name", each.name}, {"settles", each.settles}};
  report.fact("order_classes", classes);
  std::set<std::string> cloths;
  for (const report::CaseFacts& c : report.facts().cases)
    if (std::ranges::count(c.tags, "cloth") > 0) cloths.insert(c.id);
  std::vector<TimeRow> times;
  for (const TimeRow& row : result.times)
    if (cloths.contains(row.case_id)) times.push_back(row);
  report.rows("convergence", times);
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const LibrarySummary& entry : summarise(report.facts(), result.orders)) {
    list.push_back(
        {{"library", entry.library}, {"solvers", entry.solvers}, {"pairs", entry.pairs}});
    for (std::size_t i = 0; i < entry.verdicts.size(); ++i)
      list.back()[to_string(static_cast<judge::Verdict>(i))] = entry.verdicts[i];
  }
  report.manifest("verdicts", list);
}

}  // namespace

std::vector<LibrarySummary> summarise(const report::Facts& facts,
                                      const std::vector<OrderRow>& orders) {
  std::vector<LibrarySummary> list;
  LibrarySummary all{.library = "all"};
  const auto of = [&](const std::string& library) -> LibrarySummary& {
    const auto found = std::ranges::find(list, library, &LibrarySummary::library);
    return found == list.end() ? list.emplace_back(LibrarySummary{.library = library}) : *found;
  };
  for (const SolverInfo& solver : facts.solvers)
    for (LibrarySummary* entry : {&of(solver.library), &all}) ++entry->solvers;
  for (const OrderRow& row : orders)
    for (LibrarySummary* entry : {&of(row.library), &all}) {
      ++entry->pairs;
      ++entry->verdicts[static_cast<std::size_t>(row.fit.verdict)];
    }
  list.push_back(all);
  return list;
}

std::string summary_text(const report::Facts& facts, const std::vector<OrderRow>& orders) {
  record::Table table{{{"library"}, {"solvers", true}, {"pairs", true}}, {}};
  for (std::size_t i = 0; i < LibrarySummary().verdicts.size(); ++i)
    table.columns.push_back({to_string(static_cast<judge::Verdict>(i)), true});
  for (const LibrarySummary& entry : summarise(facts, orders)) {
    auto& row = table.rows.emplace_back();
    row = {report::plain(entry.library), std::to_string(entry.solvers),
           std::to_string(entry.pairs)};
    for (const std::size_t count : entry.verdicts) row.push_back(std::to_string(count));
  }
  return table.text();
}

std::unique_ptr<Study> make_convergence() {
  std::vector<std::string> quick = quick_cases();
  std::erase(quick, long_orders);
  return make_study<ConvergenceResult>(
      {.name = "converge",
       .help = "error against step, and the measured order",
       .place = 20,
       .folder = "convergence",
       .quick_help = "fewer step sizes",
       .options = {{.name = "mode",
                    .help = "fixed or adaptive; default: both",
                    .words = {"fixed", "adaptive"}}},
       .quick_report = {{.cases = quick}}},
      {.measure = converge, .table = table, .show_more = show_more});
}

}  // namespace odeum::study
