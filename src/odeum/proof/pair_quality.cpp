// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/pair_quality.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/tableau/rooted_trees.hpp"

namespace odeum::proof {
namespace {

/// sigma(tau), the number of automorphisms of a tree.
double symmetry(std::size_t tree) {
  constexpr const auto& trees = all_rooted_trees;
  if (tree == 0) return 1;
  const std::size_t right = trees.right[tree];
  double copies = 1;  // of `right` on the root
  for (std::size_t rest = trees.left[tree]; rest != 0; rest = trees.left[rest])
    if (trees.right[rest] == right) ++copies;
  return copies * symmetry(trees.left[tree]) * symmetry(right);
}

double largest(const std::vector<double>& numbers) {
  double size = 0;
  for (const double x : numbers) size = std::max(size, std::abs(x));
  return size;
}

/// Whether an estimate is zero where the error is not.
bool vanishes(const EstimateQuality& quality) { return !(quality.ratio > 1e-3); }

}  // namespace

double error_norm(const DynamicTableau<double>& tableau, const std::vector<double>& row, int order,
                  double exact) {
  constexpr const auto& trees = all_rooted_trees;
  const std::size_t s = tableau.stages;
  std::vector<std::vector<double>> phi;
  double squares = 0;
  for (std::size_t tau = 0; tau < trees.count && trees.nodes[tau] <= order; ++tau) {
    phi.emplace_back(s, 1.0);
    double sum = 0;
    for (std::size_t i = 0; i < s; ++i) {
      if (tau != 0) {
        double graft = 0;
        for (std::size_t j = 0; j < s; ++j) graft += tableau.at(i, j) * phi[trees.right[tau]][j];
        phi[tau][i] = phi[trees.left[tau]][i] * graft;
      }
      sum += row[i] * phi[tau][i];
    }
    if (trees.nodes[tau] != order) continue;
    const double residual = sum - exact / trees.density[tau];
    squares += std::pow(residual / symmetry(tau), 2);
  }
  return std::sqrt(squares);
}

PairQuality pair_quality(const DynamicTableau<double>& tableau, int order, int order_hat) {
  PairQuality quality;
  quality.largest_coefficient = std::max(
      {largest(tableau.a), largest(tableau.b), largest(tableau.c), largest(tableau.b_hat)});
  if (order > 0 && order < highest_order_checked)
    quality.principal_error = error_norm(tableau, tableau.b, order + 1);
  if (!tableau.embedded() || order == 0 || order_hat == 0) return quality;
  quality.embedded_principal_error =
      error_norm(tableau, tableau.b_hat, std::min(order_hat + 1, highest_order_checked));
  const int q = std::min(order, order_hat) + 1;
  if (q + 1 <= highest_order_checked) {
    const bool kept_is_lower = order < order_hat;
    const std::vector<double>& lower = kept_is_lower ? tableau.b : tableau.b_hat;
    const std::vector<double>& higher = kept_is_lower ? tableau.b_hat : tableau.b;
    std::vector<double> difference;
    for (std::size_t i = 0; i < lower.size(); ++i) difference.push_back(higher[i] - lower[i]);
    const double leading = error_norm(tableau, lower, q);
    quality.next_term_ratio = error_norm(tableau, lower, q + 1) / leading;
    quality.difference_ratio = error_norm(tableau, difference, q + 1, 0) / leading;
    quality.rows_ratio = error_norm(tableau, higher, q + 1) / leading;
    quality.solution_term_ratio =
        leading / error_norm(tableau, std::vector<double>(tableau.stages), q);
  }
  DynamicTableau<double> pair = tableau;
  pair.order = order;
  pair.order_hat = order_hat;
  quality.estimate = estimate_quality(interpreted(pair), order, order_hat);
  return quality;
}

std::vector<std::string> PairQuality::remarks() const {
  std::vector<std::string> remarks;
  if (solution_term_ratio > 3)
    remarks.push_back(fmt::format(
        "the lower row's leading error is {:.2g} times the term of the solution that it misses: "
        "the estimate makes steps far too short",
        solution_term_ratio));
  if (next_term_ratio > 10)
    remarks.push_back(fmt::format(
        "the lower row's leading error term is small beside the next (B = {:.2g}): the estimate is "
        "of its order only at steps much below 1/B, and may miss the error of the row that is kept",
        next_term_ratio));
  for (const EstimateQuality& q : estimate) {
    if (vanishes(q))
      remarks.push_back(fmt::format("no estimate on {} problems: it is {:.1e} of the error",
                                    q.test_problem, std::isnan(q.ratio) ? 0 : q.ratio));
    else if (q.margin < 1)
      remarks.push_back(fmt::format(
          "on the {} problem the estimate is {:.2g} of the error of the row that is kept",
          q.test_problem, q.margin));
  }
  return remarks;
}

std::string PairQuality::text() const {
  std::string text = fmt::format("principal error norms: A of b {:.3e}", principal_error);
  if (!std::isnan(embedded_principal_error))
    text += fmt::format(", of b_hat {:.3e}", embedded_principal_error);
  text += fmt::format("; largest coefficient D = {:.4g}\n", largest_coefficient);
  if (!std::isnan(next_term_ratio))
    text += fmt::format("Prince and Dormand's ratios: B = {:.3g}, C = {:.3g}, E = {:.3g}\n",
                        next_term_ratio, difference_ratio, rows_ratio);
  for (const EstimateQuality& q : estimate)
    text += fmt::format(
        "  {:<12}{:<16}{:.3g} of the error of the lower row, {:.3g} of that of b; h^{:.2f}\n",
        "estimate", q.test_problem, q.ratio, q.margin, q.exponent);
  for (const std::string& remark : remarks()) text += "remark: " + remark + '\n';
  return text;
}

}  // namespace odeum::proof
