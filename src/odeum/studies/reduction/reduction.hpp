// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/judge/order_fit.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// The order of one solver at one stiffness: a line of order_reduction.csv.
struct ReductionRow {
  std::string library, solver;
  double lambda = nan;  ///< of y' = lambda (y - cos t) - sin t
  double claimed_order = nan;
  judge::OrderFit fit;
  double error_finest = nan;  ///< absolute, at the finest step; NaN where that failed

  static constexpr const char* file = "order_reduction.csv";
  static constexpr const char* shown =
      "solver lambda:.0e claimed_order:.3g measured_order:.3f error_finest:.1e verdict";
  ODEUM_COLUMNS(library, solver, lambda, claimed_order, column("measured_order", fit.order),
                error_finest, column("order_low", fit.low), column("order_high", fit.high),
                fit.points, fit.verdict, fit.reason)
};

/// Its interval, and its runs.
inline constexpr double reduction_end = 2;
inline constexpr std::uint64_t reduction_fewest = 8, reduction_most = 512;

struct ReductionResult {
  std::vector<ReductionRow> rows;
  static auto lists(auto& result) { return std::tie(result.rows); }
};

/// Prothero and Robinson's problem from y = 1 at t = 0, which cos t solves, to t = 2 for lambda =
/// -1, -10, ..., -1e8 at 8, 16, ..., 512 fixed steps: the same window of steps at every lambda.
/// Where the stages of a method are of lower order than the method, the order falls as h lambda
/// grows. Explicit solvers are run too, until they fail. Throws Interrupted.
ReductionResult measure_reduction(const Options& options, const Runner& runner = Runner());

}  // namespace odeum::study
