// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/report/html.hpp"
#include "odeum/report/page_sections.hpp"
#include "odeum/tableau/rooted_trees.hpp"

namespace odeum::report {
namespace {

using study::ProofRow;

std::string cell(const std::string& text, const std::string& title = "") {
  return title.empty() ? fmt::format("<td>{}</td>", escape(text))
                       : fmt::format("<td title=\"{}\">{}</td>", escape(title), escape(text));
}

std::string conditions_cell(const ProofRow& row) {
  if (!row.conditions) return cell("–", "no tableau");
  std::string text = std::to_string(*row.conditions);
  if (row.conditions_embedded) text += fmt::format("({})", *row.conditions_embedded);
  return cell(text, row.failing_tree.empty()
                        ? fmt::format("no condition fails up to order {}", highest_order_checked)
                        : "first condition that fails: " + row.failing_tree);
}

std::string measured_cell(const ProofRow& row, const std::vector<study::ProvenOrder>& orders) {
  if (orders.empty()) return cell("by cases", row.needs);
  std::string text, title;
  for (const study::ProvenOrder& order : orders) {
    const bool confirmed = order.fit.verdict == judge::Verdict::confirmed;
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", show_number(order.fit.order, 3),
                        confirmed ? "" : "*");
    title += fmt::format("{}{}: {}", title.empty() ? "" : "; ", order.ground,
                         to_string(order.fit.verdict));
  }
  return cell(text, title);
}

std::string structure_cell(const ProofRow& row) {
  if (std::isnan(row.symplectic_defect)) return cell("–");
  std::string text;
  if (row.symplectic()) text = "symplectic";
  if (row.reversible()) text += text.empty() ? "reversible" : ", reversible";
  return cell(text.empty() ? "–" : text, fmt::format("form kept to {:.1e}, return to {:.1e}",
                                                     row.symplectic_defect, row.return_defect));
}

std::string energy_cell(const ProofRow& row) {
  if (row.energy_periods == 0) return cell("–");
  return cell(show_number(row.energy_last, 2),
              fmt::format("largest relative error in the last tenth of {:g} periods; {:.2g} in the "
                          "first tenth",
                          row.energy_periods, row.energy_first));
}

std::string estimate_cell(const ProofRow& row,
                          const std::vector<proof::EstimateQuality>& estimates) {
  if (estimates.empty()) return cell("–");
  double low = INFINITY, high = 0;
  std::string title;
  for (const proof::EstimateQuality& q : estimates) {
    low = std::min(low, q.ratio);
    high = std::max(high, q.ratio);
    title += fmt::format("{}{}: h^{:.2f} for h^{:g}, ratio {:.2g}", title.empty() ? "" : "; ",
                         q.ground, q.exponent, q.expected_exponent, q.ratio);
  }
  return fmt::format("<td title=\"{}\"{}>{}–{}{}</td>", escape(title),
                     row.estimates_well == "yes" ? "" : " class=\"missing\"", show_number(low, 2),
                     show_number(high, 2), row.estimates_well == "yes" ? "" : " ⚠");
}

std::string mutants_cell(const ProofRow& row) {
  if (row.mutants == 0) return cell("–");
  return cell(
      fmt::format("{} / {}{}", row.caught, row.mutants - row.equivalent,
                  row.survived() > 0 ? " ⚠" : ""),
      fmt::format("{} made, {} of them equivalent; every coefficient down to a change of {:g}",
                  row.mutants, row.equivalent, row.smallest_caught));
}

std::string row_html(const ProofRow& row, const study::ProofResult& proofs) {
  std::string claimed = row.order == 0 ? "–" : std::to_string(row.order);
  if (row.order_embedded != 0) claimed += fmt::format("({})", row.order_embedded);
  return fmt::format("<tr><th>{}</th>{}{}{}{}{}{}{}{}{}</tr>\n", escape(row.method), cell(claimed),
                     conditions_cell(row), measured_cell(row, proofs.orders_of(row.method)),
                     std::isnan(row.stability_difference)
                         ? cell("–")
                         : cell(fmt::format("{:.0e}", row.stability_difference),
                                fmt::format("at {} random points", row.stability_points)),
                     cell(row.has_stability_class() ? describe(row.stability) : "–"),
                     structure_cell(row), energy_cell(row),
                     estimate_cell(row, proofs.estimates_of(row.method)), mutants_cell(row));
}

}  // namespace

std::string proofs_section(const PageContext& page) {
  const study::ProofResult& proofs = page.data.proofs;
  std::string html = "<section id=\"proofs\">\n<h2>Proofs of our own methods</h2>\n";
  if (proofs.rows.empty()) return html + "<p>Not made in this run.</p>\n</section>\n";
  html += fmt::format(
      "<p>Order by the rooted-tree conditions (embedded row in brackets) and by running on a "
      "linear, "
      "a nonlinear and a non-autonomous problem with a closed solution (* not confirmed there); "
      "the "
      "running code against the stability function that follows from the coefficients; the "
      "symplectic form over one step, a step forth and back, and the energy over many periods; the "
      "error estimate over the true local error (⚠ outside {:.2f} to {:g}, or of another power of "
      "h, on one of the problems); and mutants caught of those made that are not equivalent. {} "
      "mutants were made, {} caught, {} are equivalent (no result depends on what they change), "
      "{} survived.</p>\n",
      proof::ratio_low, proof::ratio_high, proofs.made(), proofs.caught(), proofs.equivalent(),
      proofs.made() - proofs.caught() - proofs.equivalent());
  html +=
      "<div class=\"wide\"><table class=\"numbers "
      "proofs\"><thead><tr><th>method</th><th>claimed</th>"
      "<th>conditions</th><th>measured</th><th>code − R(z)</th><th>stability</th><th>structure</th>"
      "<th>energy</th><th>estimate / error</th><th>mutants caught</th></tr></thead><tbody>\n";
  for (const ProofRow& row : proofs.rows) html += row_html(row, proofs);
  return html + "</tbody></table></div>\n</section>\n";
}

}  // namespace odeum::report
