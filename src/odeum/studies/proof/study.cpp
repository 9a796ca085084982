// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/record/table.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/page.hpp"
#include "odeum/studies/proof/proof.hpp"
#include "odeum/tableau/rooted_trees.hpp"

namespace odeum::study {
namespace {

using report::Cell;
using report::show_number;

const Cell nothing{"–"};

Cell conditions_cell(const ProofRow& row) {
  if (!row.conditions) return {.text = "–", .title = "no tableau"};
  std::string text = std::to_string(*row.conditions);
  if (row.conditions_embedded) text += fmt::format("({})", *row.conditions_embedded);
  return {.text = text,
          .title = row.failing_tree.empty()
                       ? fmt::format("no condition fails up to order {}", highest_order_checked)
                       : "first condition that fails: " + row.failing_tree};
}

Cell measured_cell(const ProofRow& row, const std::vector<ProvenOrder>& orders) {
  if (orders.empty()) return {.text = "by cases", .title = row.needs};
  std::string text, title;
  for (const ProvenOrder& order : orders) {
    const bool confirmed = order.fit.verdict == judge::Verdict::confirmed;
    text += fmt::format("{}{}{}", text.empty() ? "" : " ", show_number(order.fit.order, 3),
                        confirmed ? "" : "*");
    title += fmt::format("{}{}: {}", title.empty() ? "" : "; ", order.test_problem,
                         to_string(order.fit.verdict));
  }
  return {.text = text, .title = title};
}

Cell structure_cell(const ProofRow& row) {
  if (std::isnan(row.symplectic_defect)) return nothing;
  std::string text;
  if (row.symplectic()) text = "symplectic";
  if (row.reversible()) text += text.empty() ? "reversible" : ", reversible";
  return {.text = text.empty() ? "–" : text,
          .title = fmt::format("form kept to {:.1e}, return to {:.1e}", row.symplectic_defect,
                               row.return_defect)};
}

Cell energy_cell(const ProofRow& row) {
  if (row.energy_periods == 0) return nothing;
  return {.text = show_number(row.energy_last, 2),
          .title = fmt::format(
              "largest relative error in the last tenth of {:g} periods; {:.2g} in the first tenth",
              row.energy_periods, row.energy_first)};
}

Cell estimate_cell(const ProofRow& row, const std::vector<proof::EstimateQuality>& estimates) {
  if (estimates.empty()) return nothing;
  double low = INFINITY, high = 0;
  std::string title;
  for (const proof::EstimateQuality& q : estimates) {
    low = std::min(low, q.ratio);
    high = std::max(high, q.ratio);
    title += fmt::format("{}{}: h^{:.2f} for h^{:g}, ratio {:.2g}", title.empty() ? "" : "; ",
                         q.test_problem, q.exponent, q.expected_exponent, q.ratio);
  }
  const bool well = row.estimates_well == "yes";
  return {.text = show_number(low, 2) + "–" + show_number(high, 2) + (well ? "" : " ⚠"),
          .style = well ? "" : "missing",
          .title = title};
}

Cell mutants_cell(const ProofRow& row) {
  if (row.mutants == 0) return nothing;
  return {.text = fmt::format("{} / {}{}", row.caught, row.mutants - row.equivalent,
                              row.survived() > 0 ? " ⚠" : ""),
          .title = fmt::format(
              "{} made, {} of them equivalent; every coefficient down to a change of {:g}",
              row.mutants, row.equivalent, row.smallest_caught)};
}

Cell claimed_cell(const ProofRow& row) {
  std::string claimed = row.order == 0 ? "–" : std::to_string(row.order);
  if (row.order_embedded != 0) claimed += fmt::format("({})", row.order_embedded);
  return {claimed};
}

Cell difference_cell(const ProofRow& row) {
  if (std::isnan(row.stability_difference)) return nothing;
  return {.text = fmt::format("{:.0e}", row.stability_difference),
          .title = fmt::format("at {} random points", row.stability_points)};
}

std::string html_table(const ProofResult& proofs) {
  report::Table table("numbers proofs");
  table.head({{"method"},
              {"claimed"},
              {"conditions"},
              {"measured"},
              {"code − R(z)"},
              {"stability"},
              {"structure"},
              {"energy"},
              {"estimate / error"},
              {"mutants caught"}});
  for (const ProofRow& row : proofs.rows)
    table.row(
        {row.method},
        {claimed_cell(row), conditions_cell(row), measured_cell(row, proofs.orders_of(row.method)),
         difference_cell(row), row.has_stability_class() ? Cell{describe(row.stability)} : nothing,
         structure_cell(row), energy_cell(row), estimate_cell(row, proofs.estimates_of(row.method)),
         mutants_cell(row)});
  return table.html();
}

std::string text_of(const ProofResult& proofs) {
  ProofRow all;
  for (const ProofRow& row : proofs.rows) {
    all.mutants += row.mutants;
    all.caught += row.caught;
    all.equivalent += row.equivalent;
  }
  return fmt::format(
      "<p>Order by the rooted-tree conditions (embedded row in brackets) and by running on a "
      "linear, a nonlinear and a non-autonomous problem with a closed solution (* not confirmed "
      "there); the running code against the stability function that follows from the coefficients; "
      "the symplectic form over one step, a step forward and back, and the energy over many "
      "periods; the error estimate over the true local error (⚠ outside {:.2f} to {:g}, or of "
      "another power of h, on one of the problems); and mutants caught of those made that are not "
      "equivalent. {} mutants were made, {} caught, {} are equivalent (no result depends on what "
      "they change), {} survived.</p>\n",
      proof::ratio_low, proof::ratio_high, all.mutants, all.caught, all.equivalent, all.survived());
}

std::string table(const ProofResult& result) {
  return record::table_of(result.rows, {{"method", "{solver}"},
                                        {"claimed", "{claimed_order:d}"},
                                        {"conditions", "{conditions}"},
                                        {"code - R(z)", "{stability_difference:.0e}"},
                                        {"stability", "{stability}"},
                                        {"caught", "{caught:d}"},
                                        {"survived", "{survived:d}"},
                                        {"of mutants", "{mutants:d}"}})
      .text();
}

}  // namespace

void add_section(report::Page& page, const ProofResult& result, const Origin& origin) {
  std::string html = origin_text(origin, result.rows.empty());
  if (!result.rows.empty()) html += text_of(result) + html_table(result);
  page.section({.id = "proofs",
                .title = "Proofs of our own methods",
                .place = origin.place,
                .html = html,
                .short_title = "Proofs"});
}

std::unique_ptr<Study> make_proof() {
  return make_study<ProofResult>(
      {.name = "proof",
       .help = "proofs of own methods: order conditions, stability, structure, mutants",
       .place = 80,
       .cases_help = "",
       .quick_help = "a hundredth of the periods for the energy"},
      {.measure = prove, .table = table, .section = add_section});
}

}  // namespace odeum::study
