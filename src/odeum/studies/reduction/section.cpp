// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/summary.hpp"
#include "odeum/studies/hard_cases/section.hpp"

namespace odeum::report {
namespace {

using judge::Verdict;
using study::ReductionRow;
using Rows = std::vector<const ReductionRow*>;

// From where on h lambda is large at every step of the study.
constexpr double stiff = -1e4;
// Half an order lost is more than any interval of these fits.
constexpr double noticeable = 0.5;

/// Of one solver, or of none: rows with the mildest stiffness first.
std::map<std::string, Rows> mildest_first(const ReportData& data) {
  auto sorted = by_solver(data.hard_cases.reduction, [](const ReductionRow&) { return true; });
  for (auto& [solver, rows] : sorted)
    std::stable_sort(rows.begin(), rows.end(),
                     [](const auto* a, const auto* b) { return a->lambda > b->lambda; });
  return sorted;
}

/// Whether a solver gives an error at all where the problem is stiff: explicit ones do not.
bool survives(const Rows& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const ReductionRow* row) {
    return row->lambda <= stiff && std::isfinite(row->error_finest) && row->error_finest < 1;
  });
}

double lost(const ReductionRow& row) { return row.claimed_order - row.fit.order; }

/// The most that is lost at any stiffness; NaN where no order could be fitted.
double most_lost(const Rows& rows) {
  double most = ReductionRow::nan;
  for (const ReductionRow* row : rows) most = std::fmax(most, lost(*row));
  return most;
}

std::string colour_of(const ReductionRow& row) {
  if (std::isnan(row.fit.order))
    return row.fit.verdict == judge::Verdict::higher ? "higher" : "not_applicable";
  if (lost(row) < noticeable)
    return row.fit.verdict == judge::Verdict::higher ? "higher" : "confirmed";
  return fmt::format("t{}", std::clamp(static_cast<int>(std::floor(lost(row) + 0.5)), 1, 3));
}

std::string cell(const ReductionRow& row) {
  std::string title = to_string(row.fit.verdict);
  if (!std::isnan(row.fit.order))
    title += fmt::format(": measured {:.2f} [{:.2f}, {:.2f}], claimed {}", row.fit.order,
                         row.fit.low, row.fit.high, show_number(row.claimed_order));
  else if (!row.fit.reason.empty())
    title += ": " + row.fit.reason;
  title += fmt::format("; error at the finest step {}", show_number(row.error_finest, 2));
  return fmt::format("<td class=\"{}\" title=\"{}\">{}</td>", colour_of(row), escape(title),
                     std::isnan(row.fit.order) ? style_of(row.fit.verdict).glyph
                                               : fmt::format("{:.1f}", row.fit.order));
}

std::string cells(const Rows& rows, const std::set<double, std::greater<>>& lambdas) {
  std::string html =
      fmt::format("<td class=\"claimed\">{}</td>", show_number(rows.front()->claimed_order));
  for (const double lambda : lambdas) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const auto* each) { return each->lambda == lambda; });
    html += row == rows.end() ? "<td></td>" : cell(**row);
  }
  return html;
}

}  // namespace

std::string reduction_part(const PageContext& page) {
  const auto solvers = mildest_first(page.data);
  if (solvers.empty()) return {};
  std::set<double, std::greater<>> lambdas;
  std::size_t kept = 0, reduced = 0, unstable = 0;
  for (const auto& [solver, rows] : solvers) {
    for (const ReductionRow* row : rows) lambdas.insert(row->lambda);
    if (rows.front()->fit.verdict == judge::Verdict::not_applicable) continue;
    if (!survives(rows))
      ++unstable;
    else if (!std::isnan(most_lost(rows)))
      ++(most_lost(rows) >= noticeable ? reduced : kept);
  }
  std::string head = "<th>claimed</th>";
  for (const double lambda : lambdas)
    head += fmt::format("<th>−10<sup>{:.0f}</sup></th>", std::log10(-lambda));
  const std::string tables =
      solver_tables(page, "numbers reductions", head, [&](const SolverInfo& solver) {
        const auto found = solvers.find(solver.id());
        return found == solvers.end() || !survives(found->second) ? std::string()
                                                                  : cells(found->second, lambdas);
      });
  return fmt::format(
      "<h3 id=\"reduction\">Order reduction</h3>\n<p>The order measured on y′ = λ(y − cos t) − sin "
      "t from y(0) = 1 to t = 2, at 8 to 512 steps, as λ falls: the stages of a method are of "
      "lower order than the method, and where hλ is large theirs shows. {} keep the claimed order "
      "to within {:g} wherever it can be fitted, {} lose more (orange, deeper for each whole "
      "order). {} give no usable error once λ is −10<sup>4</sup> or below (explicit ones are "
      "unstable there) and have no row. A sign instead of a number: no order can be fitted, ▲ "
      "since all errors are rounding; resting on a cell tells why.</p>\n{}",
      show_count(kept, "solver"), noticeable, reduced, unstable, tables);
}

}  // namespace odeum::report
