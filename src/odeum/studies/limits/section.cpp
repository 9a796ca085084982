// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "odeum/report/html.hpp"
#include "odeum/report/log_diagram.hpp"
#include "odeum/studies/hard_cases/section.hpp"

namespace odeum::report {
namespace {

using study::LargestStep;

/// How what was measured lies to what the spectrum predicts.
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

std::string cell(const LargestStep& row) {
  const Agreement agreement = agreement_of(row);
  std::string title = agreement == Agreement::none_bounded
                          ? row.status
                          : fmt::format("measured {}{}", at_any_step(row) ? "at least " : "",
                                        show_number(row.largest_stable_step, 4));
  if (!std::isnan(row.predicted_step))
    title += fmt::format(", predicted {} from {}", show_number(row.predicted_step, 4),
                         complex_number(row.eigenvalue));
  if (!row.detail.empty()) title += "; " + row.detail;
  const std::string text = agreement == Agreement::none_bounded ? "✗"
                           : at_any_step(row)                   ? "any"
                                              : show_number(row.largest_stable_step, 2);
  return fmt::format("<td class=\"{}\" title=\"{}\">{}</td>", style_of(agreement), escape(title),
                     text);
}

// The stiffness of each case, and how often theory and running code agree.
std::string cases_table(const PageContext& page, const std::vector<std::size_t>& measured) {
  std::string rows;
  for (const std::size_t i : measured) {
    std::array<std::size_t, agreements> counts{};
    const LargestStep* stiffest = nullptr;
    for (const LargestStep& row : page.data.hard_cases.largest_steps) {
      if (row.case_id != page.data.cases[i].id || !is_run(row)) continue;
      ++counts[static_cast<std::size_t>(agreement_of(row))];
      if (!stiffest || std::abs(row.eigenvalue) > std::abs(stiffest->eigenvalue)) stiffest = &row;
    }
    rows += fmt::format("<tr><th><a href=\"{}\"><code>{}</code></a></th><td>{}</td><td>{}</td>",
                        page.case_address(i), escape(page.data.cases[i].id),
                        complex_number(stiffest->eigenvalue), show_number(stiffest->window));
    for (std::size_t k = 0; k < agreements; ++k)
      rows += fmt::format("<td class=\"{}\">{}</td>",
                          counts[k] == 0 ? "zero" : style_of(static_cast<Agreement>(k)), counts[k]);
    rows += "</tr>\n";
  }
  return "<div class=\"wide\"><table class=\"numbers\"><thead><tr><th>case</th><th>largest "
         "eigenvalue</th><th>window</th><th>as predicted</th><th>larger</th><th>smaller</th><th>no "
         "theory</th><th>none bounded</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n";
}

// Steps in units of the eigenvalue: all cases fall on one line where the spectrum tells all.
std::string diagram(const std::vector<LargestStep>& rows) {
  LogAxes axes;
  std::vector<const LargestStep*> drawn;
  for (const LargestStep& row : rows) {
    const bool finite = std::isfinite(row.predicted_step) && row.predicted_step > 0;
    if (!finite || !(row.largest_stable_step > 0) || at_any_step(row)) continue;
    drawn.push_back(&row);
    axes.across.include(row.predicted_step * std::abs(row.eigenvalue));
    axes.up.include(row.largest_stable_step * std::abs(row.eigenvalue));
  }
  if (drawn.empty()) return {};
  axes.across = axes.across.widened(1.5);
  axes.up = axes.up.widened(1.5);
  const double low = std::max(axes.across.low, axes.up.low),
               high = std::min(axes.across.high, axes.up.high);
  std::string html = open_diagram(axes, "largest stable step, measured against predicted",
                                  [](double value) { return show_number(value); });
  if (low < high)
    html += fmt::format("<path class=\"guide\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", axes.x(low),
                        axes.y(low), axes.x(high), axes.y(high));
  html += "<g class=\"cloud\">";
  for (const LargestStep* row : drawn) {
    const double size = std::abs(row->eigenvalue);
    html += fmt::format(
        "<use href=\"#m{}\" x=\"{:.1f}\" y=\"{:.1f}\" class=\"best\"><title>{}</title></use>",
        row->eigenvalue.imag() == 0 ? 0 : 1, axes.x(row->predicted_step * size),
        axes.y(row->largest_stable_step * size),
        escape(fmt::format("{}/{} on {}: measured {}, predicted {}", row->library, row->solver,
                           row->case_id, show_number(row->largest_stable_step, 4),
                           show_number(row->predicted_step, 4))));
  }
  html += "</g>" + close_diagram("predicted step times |λ|, log", "measured step times |λ|, log");
  return "<figure class=\"speed\">" + html +
         "<ul class=\"legend\"><li><svg viewBox=\"-9 -5 18 10\" aria-hidden=\"true\"><use "
         "href=\"#m0\"/></svg>bound by a real eigenvalue</li><li><svg viewBox=\"-9 -5 18 10\" "
         "aria-hidden=\"true\"><use href=\"#m1\"/></svg>by a complex pair</li></ul></figure>\n";
}

constexpr const char* text =
    "<p>The largest step with which a run stays bounded over the window (the case's horizon, "
    "halved until the stiffness allows it), beside what the method's stability function allows for "
    "the eigenvalues along the solution: <span class=\"chip confirmed\">as predicted</span> to 5 "
    "%, "
    "<span class=\"chip higher\">larger</span> or <span class=\"chip lower\">smaller</span>; "
    "uncoloured where no stability function is known, as for every peer. \"any\": bounded with "
    "four steps in the window, the fewest that are tried. Larger is to be expected where an "
    "eigenvalue is imaginary, since growth by a hair a step does not show in the window, and on "
    "nonlinear problems, where what grows changes the spectrum. Smaller: the run was ended by what "
    "a linear theory "
    "does not know, such as Newton's iteration or an overshoot; resting on a cell tells "
    "what.</p>\n";

}  // namespace

std::string largest_steps_part(const PageContext& page) {
  const std::vector<LargestStep>& rows = page.data.hard_cases.largest_steps;
  std::set<std::string> run;
  for (const LargestStep& row : rows)
    if (is_run(row)) run.insert(row.case_id);
  std::vector<std::size_t> measured;
  std::string head;
  for (std::size_t i = 0; i < page.data.cases.size(); ++i)
    if (run.contains(page.data.cases[i].id)) {
      measured.push_back(i);
      head += fmt::format("<th class=\"turned\"><a href=\"{}\">{}</a></th>", page.case_address(i),
                          escape(page.data.cases[i].id));
    }
  if (measured.empty()) return {};
  const RowsByPair<LargestStep> pairs = by_pair(rows);
  const std::string tables =
      solver_tables(page, "matrix steps", head, [&](const SolverInfo& solver) {
        std::string html;
        bool any = false;
        for (const std::size_t i : measured) {
          const auto found = pairs.find({page.data.cases[i].id, solver.id()});
          const bool is = found != pairs.end() && is_run(*found->second.front());
          html += is ? cell(*found->second.front()) : "<td class=\"not_applicable\">·</td>";
          any |= is;
        }
        return any ? html : std::string();
      });
  return std::string("<h3 id=\"largest-steps\">Largest stable step</h3>\n") + text +
         cases_table(page, measured) + diagram(rows) + tables;
}

}  // namespace odeum::report
