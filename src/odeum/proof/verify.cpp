// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/judge/stability_search.hpp"
#include "odeum/proof/order_check.hpp"

namespace odeum::proof {
namespace {

constexpr std::size_t longest_fraction = 60;

std::string written(const mpq_class& x) {
  const std::string fraction = x.get_str();
  if (fraction.size() > longest_fraction) return fmt::format("{:.6g}", x.get_d());
  return x.get_den() == 1 || x.get_den() < 1000 ? fraction
                                                : fmt::format("{} = {:.6g}", fraction, x.get_d());
}
std::string written(const mpf_class& x) { return fmt::format("{:.6g}", x.get_d()); }

template <class Number>
RowProof prove_row(const char* name, const DynamicTableau<Number>& tableau,
                   const std::vector<Number>& row, int claimed,
                   const CoefficientRounding& rounding) {
  const RowOrder<Number> found = order_of_row(tableau, row, rounding);
  RowProof proof;
  proof.row = name;
  proof.claimed = claimed;
  proof.order = found.order;
  proof.at_limit = !found.fails;
  if (found.fails) {
    proof.tree = bracket_notation(found.tree);
    proof.residual = written(found.residual);
    proof.failing = found.failing;
    proof.of = found.of;
  }
  return proof;
}

template <class Number>
std::vector<NodeFault> node_faults(const DynamicTableau<Number>& tableau,
                                   const CoefficientRounding& rounding) {
  std::vector<NodeFault> faults;
  for (std::size_t i = 0; i < tableau.stages; ++i) {
    const Number sum = tableau.row_sum(i), difference = tableau.c[i] - sum;
    double size = 0;
    for (std::size_t j = 0; j < tableau.stages; ++j)
      size += std::abs(detail::as_double(tableau.at(i, j)));
    const double allowance =
        rounding.relative * (size + std::abs(detail::as_double(tableau.c[i]))) +
        rounding.absolute * static_cast<double>(tableau.stages + 1);
    if (std::abs(detail::as_double(difference)) > allowance)
      faults.push_back({i + 1, written(tableau.c[i]), written(sum)});
  }
  return faults;
}

double limit_along(const DynamicTableau<double>& tableau, std::complex<double> direction) {
  return judge::find_limit([&](double x) {
           const double amplification = std::abs(stability_function(tableau, direction * x));
           return judge::Growth{std::log(amplification), judge::growth_rounding};
         })
      .limit;
}

void run_row(const char* name, const DynamicTableau<double>& tableau, int order,
             std::vector<MeasuredRow>& measured) {
  if (order == 0) return;  // not consistent: it does not converge
  // A leading error term that is small beside the next is seen at steps below their ratio alone.
  const double next =
      order + 2 <= highest_order_checked
          ? error_norm(tableau, tableau.b, order + 2) / error_norm(tableau, tableau.b, order + 1)
          : 0;
  constexpr double small_beside = 10;
  for (const TestProblem<FunctionProblem>& test : test_problems()) {
    MeasuredRow row{name, test.id, measure_order(interpreted(tableau), order, test), false, ""};
    const bool above = row.fit.verdict == judge::Verdict::higher || row.fit.order > order;
    // A linear problem has few order conditions: a higher order there, or slopes on the way from
    // one, do not contradict the claim.
    row.agrees = row.fit.verdict == judge::Verdict::confirmed || (test.id == "linear" && above);
    if (!row.agrees && row.fit.order > order && next > small_beside) {
      row.agrees = true;
      row.note = fmt::format(
          ": the next order's error terms are {:.1e} times the leading ones, which are too small "
          "to be seen",
          next);
    }
    measured.push_back(std::move(row));
  }
}

std::string row_text(const RowProof& row) {
  std::string text =
      fmt::format("  {:<12}order {}{}", row.row, row.at_limit ? "at least " : "", row.order);
  if (row.claimed != 0)
    text += fmt::format(
        ", {} claimed: {}", row.claimed,
        row.reached() ? (row.order > row.claimed ? "more than that" : "reached") : "NOT REACHED");
  text += '\n';
  if (!row.tree.empty())
    text += fmt::format("  {:<12}order {} fails: {} of {} conditions, first {}, residual {}\n", "",
                        row.order + 1, row.failing, row.of, row.tree, row.residual);
  return text;
}

}  // namespace

bool Verification::passed() const {
  return main.reached() && (embedded.row.empty() || embedded.reached()) && nodes.empty() &&
         std::ranges::all_of(measured, [](const MeasuredRow& row) { return row.agrees; });
}

Verification verify(const TableauFile& file) {
  Verification v;
  std::visit(
      [&](const auto& t) {
        v.main = prove_row("b", t, t.b, t.order, file.rounding);
        if (t.embedded()) v.embedded = prove_row("b_hat", t, t.b_hat, t.order_hat, file.rounding);
        v.nodes = node_faults(t, file.rounding);
      },
      file.tableau);
  const DynamicTableau<double>& t = file.rounded;
  v.structure = structure_of(t);
  v.stability = stability_class(t);
  v.real_limit = limit_along(t, -1);
  v.imaginary_limit = limit_along(t, {0, 1});
  run_row("b", t, v.main.order, v.measured);
  if (t.embedded()) {
    DynamicTableau<double> other = t;
    other.b = t.b_hat;
    other.b_hat.clear();
    run_row("b_hat", other, v.embedded.order, v.measured);
  }
  v.quality = pair_quality(t, v.main.order, t.embedded() ? v.embedded.order : 0);
  return v;
}

std::string Verification::text(const TableauFile& file) const {
  std::string text =
      fmt::format("{}, {} stage{}: {}\n", file.name.empty() ? "Tableau" : file.name,
                  file.rounded.stages, file.rounded.stages == 1 ? "" : "s", describe(structure));
  text += fmt::format("order conditions, {}\n",
                      !file.exact() ? "to 512 bits"
                      : file.rounding.absolute == 0
                          ? "in exact fractions"
                          : "decimals of 15 digits and more taken as rounded");
  text += row_text(main);
  if (!embedded.row.empty()) text += row_text(embedded);
  if (!file.has_nodes)
    text += "nodes c: the row sums\n";
  else if (nodes.empty())
    text += "nodes c: as stated, and the row sums\n";
  for (const NodeFault& fault : nodes)
    text += fmt::format("nodes c: c[{}] = {} CONTRADICTS the row sum {}\n", fault.stage,
                        fault.stated, fault.row_sum);
  text += fmt::format("stability: real axis to {:.7g}, imaginary axis to {:.7g}; {}\n", real_limit,
                      imaginary_limit, describe(stability));
  text += "measured by running\n";
  for (const MeasuredRow& row : measured)
    text +=
        fmt::format("  {:<12}{:<16}order {:.2f} {}{}\n", row.row, row.test_problem, row.fit.order,
                    row.agrees ? "as the conditions say" : "DISAGREES with the conditions",
                    row.agrees               ? row.note
                    : row.fit.reason.empty() ? ""
                                             : ": " + row.fit.reason);
  if (measured.empty()) text += "  nothing: the row is not consistent\n";
  text += quality.text();
  const std::size_t remarks = quality.remarks().size();
  text += passed() ? "passed" : "failed";
  if (remarks > 0) text += fmt::format(", with {} remark{}", remarks, remarks == 1 ? "" : "s");
  return text + '\n';
}

}  // namespace odeum::proof
