// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/reduction/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/solver_tables.hpp"
#include "odeum/report/verdict_style.hpp"

namespace odeum::study {
namespace {

using report::Cell;
using report::show_number;
using Rows = std::vector<const ReductionRow*>;

// From where on h lambda is large at every step of the study.
constexpr double stiff = -1e4;
// Half an order lost is more than any interval of these fits.
constexpr double noticeable = 0.5;

/// By solver, rows with the mildest stiffness first.
std::map<std::string, Rows> mildest_first(const std::vector<ReductionRow>& rows) {
  auto sorted = report::by_solver(rows, [](const ReductionRow&) { return true; });
  for (auto& [solver, own] : sorted)
    std::stable_sort(own.begin(), own.end(),
                     [](const auto* a, const auto* b) { return a->lambda > b->lambda; });
  return sorted;
}

/// Whether a solver gives an error at all where the problem is stiff: explicit ones do not.
bool is_usable(const Rows& rows) {
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
  const bool higher = row.fit.verdict == judge::Verdict::higher;
  if (std::isnan(row.fit.order)) return higher ? "higher" : "not_applicable";
  if (lost(row) < noticeable) return higher ? "higher" : "confirmed";
  return fmt::format("t{}", std::clamp(static_cast<int>(std::floor(lost(row) + 0.5)), 1, 3));
}

Cell cell_of(const ReductionRow& row) {
  const judge::OrderFit& fit = row.fit;
  const bool fitted = !std::isnan(fit.order);
  std::string title = to_string(fit.verdict);
  if (fitted)
    title += fmt::format(": measured {:.2f} [{:.2f}, {:.2f}], claimed {}", fit.order, fit.low,
                         fit.high, show_number(row.claimed_order));
  else if (!fit.reason.empty())
    title += ": " + fit.reason;
  title += fmt::format("; error at the finest step {}", show_number(row.error_finest, 2));
  return {.text = fitted ? fmt::format("{:.1f}", fit.order) : report::style_of(fit.verdict).glyph,
          .style = colour_of(row),
          .title = title};
}

using Lambdas = std::set<double, std::greater<>>;

std::vector<Cell> cells_of(const Rows& rows, const Lambdas& lambdas) {
  std::vector<Cell> cells{{.text = show_number(rows.front()->claimed_order), .style = "claimed"}};
  for (const double lambda : lambdas) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const auto* each) { return each->lambda == lambda; });
    cells.push_back(row == rows.end() ? Cell() : cell_of(**row));
  }
  return cells;
}

std::string summary(const std::map<std::string, Rows>& solvers) {
  std::size_t kept = 0, reduced = 0, unstable = 0;
  for (const auto& [solver, rows] : solvers) {
    if (rows.front()->fit.verdict == judge::Verdict::not_applicable) continue;
    if (!is_usable(rows))
      ++unstable;
    else if (!std::isnan(most_lost(rows)))
      ++(most_lost(rows) >= noticeable ? reduced : kept);
  }
  return fmt::format(
      "<p>The order measured on y′ = λ(y − cos t) − sin t from y(0) = 1 to t = 2, at 8 to 512 "
      "steps, as λ falls: the stages of a method are of lower order than the method, and for large "
      "hλ their order is what remains. {} keep the claimed order to within {:g} wherever it can be "
      "fitted, {} lose more (orange, deeper for each whole order). {} give no usable error once λ "
      "is −10<sup>4</sup> or below (explicit ones are unstable there) and have no row. A sign "
      "instead of a number: no order can be fitted, ▲ since all errors are rounding; the tooltip "
      "of "
      "a cell gives the reason.</p>\n",
      report::show_count(kept, "solver"), noticeable, reduced, unstable);
}

}  // namespace

void add_section(report::Page& page, const ReductionResult& result, const report::Origin& origin) {
  const auto solvers = mildest_first(result.rows);
  std::string html = report::origin_text(origin, solvers.empty());
  if (!solvers.empty()) {
    Lambdas lambdas;
    for (const ReductionRow& row : result.rows) lambdas.insert(row.lambda);
    std::vector<Cell> head{{"claimed"}};
    for (const double lambda : lambdas)
      head.push_back({.markup = fmt::format("−10<sup>{:.0f}</sup>", std::log10(-lambda))});
    const auto cells = [&](const SolverInfo& solver) {
      const auto found = solvers.find(solver.id());
      return found == solvers.end() || !is_usable(found->second) ? std::vector<Cell>()
                                                                 : cells_of(found->second, lambdas);
    };
    html +=
        summary(solvers) + report::solver_tables(page.facts(), "numbers reductions", head, cells);
  }
  page.section(
      {.id = "reduction", .title = "Order reduction", .place = origin.place, .html = html});
}

}  // namespace odeum::study
