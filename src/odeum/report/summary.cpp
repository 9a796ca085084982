// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "odeum/report/html.hpp"

namespace odeum::report {
namespace {

constexpr bool styles_are_in_order() {
  for (std::size_t i = 0; i < verdict_styles.size(); ++i)
    if (static_cast<std::size_t>(verdict_styles[i].verdict) != i) return false;
  return true;
}
static_assert(styles_are_in_order(), "style_of looks a verdict up by its number");

}  // namespace

std::vector<LibrarySummary> summarise(const ReportData& data) {
  std::vector<LibrarySummary> list;
  for (const std::string& name : library_names(data)) list.push_back({.library = name});
  LibrarySummary all{.library = "all"};
  const auto entry = [&](const std::string& library) {
    return std::find_if(list.begin(), list.end(),
                        [&](const LibrarySummary& s) { return s.library == library; });
  };
  for (const SolverInfo& solver : data.solvers) {
    ++entry(solver.library)->solvers;
    ++all.solvers;
  }
  for (const study::OrderRow& row : data.convergence.orders) {
    const auto verdict = static_cast<std::size_t>(row.fit.verdict);
    if (const auto found = entry(row.library); found != list.end()) {
      ++found->pairs;
      ++found->verdicts[verdict];
    }
    ++all.pairs;
    ++all.verdicts[verdict];
  }
  list.push_back(all);
  return list;
}

std::map<std::string, std::size_t> status_counts(const ReportData& data) {
  std::map<std::string, std::size_t> counts;
  for (const auto& row : data.convergence.rows) ++counts[row.status];
  for (const auto& limit : data.stability.limits) ++counts[limit.status];
  return counts;
}

std::string summary_table(const ReportData& data, const record::OutputFolder& folder) {
  const std::vector<LibrarySummary> list = summarise(data);
  std::size_t width = 7;
  for (const LibrarySummary& entry : list) width = std::max(width, plain(entry.library).size());
  std::string text = fmt::format("{:<{}} {:>8} {:>6}", "library", width, "solvers", "pairs");
  for (const VerdictStyle& style : verdict_styles)
    text += fmt::format("  {}", to_string(style.verdict));
  text += '\n';
  for (const LibrarySummary& entry : list) {
    text +=
        fmt::format("{:<{}} {:>8} {:>6}", plain(entry.library), width, entry.solvers, entry.pairs);
    for (const VerdictStyle& style : verdict_styles) {
      const std::string name = to_string(style.verdict);
      text += fmt::format("  {:>{}}", entry.count(style.verdict), name.size());
    }
    text += '\n';
  }
  return text + fmt::format("report: {}\n", plain((folder.path() / "index.html").string()));
}

}  // namespace odeum::report
