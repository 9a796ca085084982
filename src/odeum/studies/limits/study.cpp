// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "odeum/record/table.hpp"
#include "odeum/report/chart.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/page.hpp"
#include "odeum/report/solver_tables.hpp"
#include "odeum/studies/limits/limits.hpp"

namespace odeum::study {
namespace {

using report::Cell;
using report::show_number;

/// The measured limit against the one that the spectrum predicts.
enum class Agreement { near, above, below, no_theory, none_bounded };
constexpr std::size_t agreements = 5;

// The search ends within 0.5 % or one step of the window; a spectrum that moves does the rest.
constexpr double allowed = 1.05;

/// Bounded at the largest step that was tried: a quarter of the window.
bool at_any_step(const LargestStep& row) { return row.largest_stable_step > 0.249 * row.window; }

Agreement agreement_of(const LargestStep& row) {
  if (row.status != to_string(Status::ok)) return Agreement::none_bounded;
  if (std::isnan(row.predicted_step)) return Agreement::no_theory;
  if (at_any_step(row))
    return row.predicted_step * allowed >= row.largest_stable_step ? Agreement::near
                                                                   : Agreement::above;
  if (row.largest_stable_step > allowed * row.predicted_step) return Agreement::above;
  return row.largest_stable_step * allowed < row.predicted_step ? Agreement::below
                                                                : Agreement::near;
}

const char* style_of(Agreement agreement) {
  constexpr const char* styles[agreements] = {"confirmed", "higher", "lower", "", "failed"};
  return styles[static_cast<std::size_t>(agreement)];
}

bool is_run(const LargestStep& row) { return row.status != "not_applicable"; }

std::string complex_number(const std::complex<double>& z) {
  if (std::isnan(z.real())) return "–";
  if (z.imag() == 0) return show_number(z.real());
  // A real part that rounding left is none.
  if (std::abs(z.real()) <= 1e-7 * std::abs(z))
    return fmt::format("± {}i", show_number(std::abs(z.imag())));
  return fmt::format("{} ± {}i", show_number(z.real()), show_number(std::abs(z.imag())));
}

Cell cell_of(const LargestStep& row) {
  const Agreement agreement = agreement_of(row);
  const bool bounded = agreement != Agreement::none_bounded;
  std::string title = !bounded ? row.status
                               : fmt::format("measured {}{}", at_any_step(row) ? "at least " : "",
                                             show_number(row.largest_stable_step, 4));
  if (!std::isnan(row.predicted_step))
    title += fmt::format(", predicted {} from {}", show_number(row.predicted_step, 4),
                         complex_number(row.eigenvalue));
  if (!row.detail.empty()) title += "; " + row.detail;
  return {.text = !bounded           ? "✗"
                  : at_any_step(row) ? "any"
                                     : show_number(row.largest_stable_step, 2),
          .style = style_of(agreement),
          .title = title};
}

using RowsByCase = std::map<std::string, std::map<std::string, const LargestStep*>>;

// The stiffness of each case, and how often theory and running code agree.
std::string cases_table(const std::vector<const report::CaseFacts*>& cases,
                        const RowsByCase& rows) {
  report::Table table("numbers");
  table.head({{"case"},
              {"largest eigenvalue"},
              {"window"},
              {"as predicted"},
              {"larger"},
              {"smaller"},
              {"no theory"},
              {"none bounded"}});
  for (const report::CaseFacts* c : cases) {
    std::array<std::size_t, agreements> counts{};
    const LargestStep* stiffest = nullptr;
    for (const auto& [solver, row] : rows.at(c->id)) {
      ++counts[static_cast<std::size_t>(agreement_of(*row))];
      if (!stiffest || std::abs(row->eigenvalue) > std::abs(stiffest->eigenvalue)) stiffest = row;
    }
    std::vector<Cell> cells{{complex_number(stiffest->eigenvalue)},
                            {show_number(stiffest->window)}};
    for (std::size_t k = 0; k < agreements; ++k)
      cells.push_back({.text = std::to_string(counts[k]),
                       .style = counts[k] == 0 ? "zero" : style_of(static_cast<Agreement>(k))});
    table.row({.markup = report::case_link(*c)}, cells);
  }
  return table.html();
}

// Steps in units of the eigenvalue: all cases fall on one line where the spectrum explains them.
std::string diagram(const std::vector<LargestStep>& rows) {
  report::Axis predicted, measured;
  std::vector<const LargestStep*> drawn;
  for (const LargestStep& row : rows) {
    const bool finite = std::isfinite(row.predicted_step) && row.predicted_step > 0;
    if (!finite || !(row.largest_stable_step > 0) || at_any_step(row)) continue;
    drawn.push_back(&row);
    predicted.include(row.predicted_step * std::abs(row.eigenvalue));
    measured.include(row.largest_stable_step * std::abs(row.eigenvalue));
  }
  if (drawn.empty()) return {};
  predicted = predicted.widened(1.5);
  measured = measured.widened(1.5);
  report::Chart chart(report::large_chart, predicted, measured,
                      {.x = "predicted step times |λ|",
                       .y = "measured step times |λ|",
                       .description = "largest stable step, measured against predicted"});
  const double low = std::max(predicted.low, measured.low),
               high = std::min(predicted.high, measured.high);
  if (low < high) chart.line({{low, low}, {high, high}}, "guide");
  for (const LargestStep* row : drawn) {
    const double size = std::abs(row->eigenvalue);
    chart.mark({row->predicted_step * size, row->largest_stable_step * size},
               row->eigenvalue.imag() == 0 ? 0 : 1, "faint",
               fmt::format("{}/{} on {}: measured {}, predicted {}", row->library, row->solver,
                           row->case_id, show_number(row->largest_stable_step, 4),
                           show_number(row->predicted_step, 4)));
  }
  return "<figure class=\"speed\">" + chart.svg() +
         report::legend({{.text = "limited by a real eigenvalue", .style = 0},
                         {.text = "by a complex pair", .style = 1}}) +
         "</figure>\n";
}

constexpr const char* text =
    "<p>The largest step with which a run stays bounded over the window (the case's horizon, "
    "halved until the stiffness allows it), beside what the method's stability function allows for "
    "the eigenvalues along the solution: <span class=\"chip confirmed\">as predicted</span> to 5 "
    "%, <span class=\"chip higher\">larger</span> or <span class=\"chip lower\">smaller</span>; "
    "uncoloured where no stability function is known, as for every peer. \"any\": bounded with "
    "four steps in the window, the fewest that are tried. Larger is to be expected where an "
    "eigenvalue is imaginary, since slow growth does not show in the window, and on nonlinear "
    "problems, where growth changes the spectrum. Smaller: the run was ended by what a linear "
    "theory does not cover, such as Newton's iteration or an overshoot; the tooltip of a cell "
    "gives the reason.</p>\n";

std::string table(const LimitsResult& result) {
  return record::table_of(result.rows, {{"case", "{case}"},
                                        {"solver", "{library}/{solver}"},
                                        {"measured", "{largest_stable_step:.4g}"},
                                        {"predicted", "{predicted_step:.4g}"},
                                        {"eigenvalue", "{eigenvalue_re:.3g} {eigenvalue_im:+.3g}i"},
                                        {"remark", "{status}: {detail}"}})
      .text();
}

}  // namespace

void add_section(report::Page& page, const LimitsResult& result, const Origin& origin) {
  RowsByCase by_case;
  for (const LargestStep& row : result.rows)
    if (is_run(row)) by_case[row.case_id][row.library + "/" + row.solver] = &row;
  std::vector<const report::CaseFacts*> cases;
  std::vector<Cell> head;
  for (const report::CaseFacts& c : page.facts().cases)
    if (by_case.contains(c.id)) {
      cases.push_back(&c);
      head.push_back(report::case_head(c));
    }
  const auto cells = [&](const std::vector<const LargestStep*>& rows) {
    return report::cells_by_column(
        rows, cases,
        [](const LargestStep& row, const report::CaseFacts* c) { return row.case_id == c->id; },
        cell_of, {.text = "·", .style = "not_applicable"});
  };
  std::string html = origin_text(origin, cases.empty());
  if (!cases.empty())
    html += text + cases_table(cases, by_case) + diagram(result.rows) +
            report::solver_tables(page.facts(), "matrix steps", head,
                                  report::by_solver(result.rows, is_run), cells);
  page.section(
      {.id = "largest-steps", .title = "Largest stable step", .place = origin.place, .html = html});
}

// A report runs own solvers on every stiff case; peers on a decay, a relaxation and a vibration.
std::unique_ptr<Study> make_limits() {
  return make_study<LimitsResult>(
      {.name = "limits",
       .help = "the largest stable step on stiff cases, and the prediction of the spectrum",
       .place = 50,
       .cases_help = "cases, with * and ?; default: the stiff ones",
       .report = {{.solvers = {"odeum/*"}},
                  {.cases = {"prothero_robinson_1e3_smooth", "vdp_mu1000", "stiff_chain2_k1e4"},
                   .solvers = {"!odeum/*"}}}},
      {.measure = measure_limits, .table = table, .section = add_section});
}

}  // namespace odeum::study
