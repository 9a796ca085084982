// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/record/table.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/page.hpp"
#include "odeum/report/solver_tables.hpp"
#include "odeum/report/verdict_style.hpp"
#include "odeum/studies/reduction/reduction.hpp"

namespace odeum::study {
namespace {

using report::Cell;
using report::show_number;
using Rows = std::vector<const ReductionRow*>;

// From where on h lambda is large at every step of the study.
constexpr double stiff = -1e4;
// Half an order lost is more than any interval of these fits.
constexpr double noticeable = 0.5;

/// Whether a solver gives an error at all where the problem is stiff: explicit ones do not.
bool is_usable(const Rows& rows) {
  return std::any_of(rows.begin(), rows.end(), [](const ReductionRow* row) {
    return row->lambda <= stiff && std::isfinite(row->error_finest) && row->error_finest < 1;
  });
}

double lost(const ReductionRow& row) { return row.claimed_order - row.fit.order; }

/// The most that is lost at any stiffness; NaN where no order could be fitted.
double most_lost(const Rows& rows) {
  double most = record::nan;
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
  if (!is_usable(rows)) return {};
  std::vector<Cell> cells = report::cells_by_column(
      rows, lambdas, [](const ReductionRow& row, double lambda) { return row.lambda == lambda; },
      cell_of);
  cells.insert(cells.begin(),
               {.text = show_number(rows.front()->claimed_order), .style = "claimed"});
  return cells;
}

std::string summary(const report::RowsBySolver<ReductionRow>& solvers) {
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
      "of a cell gives the reason.</p>\n",
      report::show_count(kept, "solver"), noticeable, reduced, unstable);
}

std::string table(const ReductionResult& result) {
  return record::table_of(result.rows, {{"solver", "{library}/{solver}"},
                                        {"lambda", "{lambda:.0e}"},
                                        {"claimed", "{claimed_order:.3g}"},
                                        {"measured", "{measured_order:.3f}"},
                                        {"error", "{error_finest:.1e}"},
                                        {"verdict", "{verdict}: {reason}"}})
      .text();
}

}  // namespace

void add_section(report::Page& page, const ReductionResult& result, const Origin& origin) {
  const auto solvers = report::by_solver(result.rows, [](const ReductionRow&) { return true; });
  std::string html = origin_text(origin, solvers.empty());
  if (!solvers.empty()) {
    Lambdas lambdas;
    for (const ReductionRow& row : result.rows) lambdas.insert(row.lambda);
    std::vector<Cell> head{{"claimed"}};
    for (const double lambda : lambdas)
      head.push_back({.markup = fmt::format("−10<sup>{:.0f}</sup>", std::log10(-lambda))});
    html += summary(solvers) +
            report::solver_tables(page.facts(), "numbers reductions", head, solvers,
                                  [&](const Rows& rows) { return cells_of(rows, lambdas); });
  }
  page.section(
      {.id = "reduction", .title = "Order reduction", .place = origin.place, .html = html});
}

std::unique_ptr<Study> make_reduction() {
  return make_study<ReductionResult>(
      {.name = "reduction",
       .help = "the order on Prothero and Robinson's problem as it becomes stiff",
       .place = 40,
       .cases_help = ""},
      {.measure = measure_reduction, .table = table, .section = add_section});
}

}  // namespace odeum::study
