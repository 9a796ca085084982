// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/report/page.hpp"
#include "odeum/report/solver_tables.hpp"
#include "odeum/report/verdict_style.hpp"
#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::study {

/// What the page shows of a result: an overview, the matrix of orders, what did not confirm, what
/// was skipped; on the page of each case plots and its orders.
void add_section(report::Page& page, const ConvergenceResult& result, const Origin& origin);

/// Counts by Verdict.
using VerdictCounts = std::array<std::size_t, report::verdict_styles.size()>;
inline std::size_t& of(VerdictCounts& counts, judge::Verdict verdict) {
  return counts[static_cast<std::size_t>(verdict)];
}

/// How the solvers of one library did. A pair is a solver on a case in a mode.
struct LibrarySummary {
  std::string library;
  std::size_t solvers = 0, pairs = 0;
  VerdictCounts verdicts{};
};
/// One entry a library, then one for all of them, with the name "all".
std::vector<LibrarySummary> summarise(const report::Facts& facts,
                                      const std::vector<OrderRow>& orders);
/// The same for a terminal.
std::string summary_text(const report::Facts& facts, const std::vector<OrderRow>& orders);

/// Rows by case, solver ("library/method") and mode. Points into the rows.
using PairKey = std::tuple<std::string, std::string, Mode>;
template <class Row>
std::map<PairKey, std::vector<const Row*>> by_pair(const std::vector<Row>& rows) {
  return report::group_by(rows, [](const Row& row) {
    return PairKey(row.case_id, row.library + "/" + row.solver, row.mode);
  });
}

/// A bar with a length for each verdict but "not applicable", and "3 confirmed, 1 lower".
std::string verdict_bar(const VerdictCounts& counts);
std::string verdict_words(const VerdictCounts& counts);

/// Whether any pair of a case was judged.
bool is_measured(const std::vector<OrderRow>& orders, const std::string& case_id);

/// The parts, in the files section_*.cpp.
std::string overview(const report::Facts& facts, const std::vector<OrderRow>& orders);
void add_verdicts(report::Page& page, const ConvergenceResult& result);
void add_plots(report::Page& page, const ConvergenceResult& result);

}  // namespace odeum::study
