// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "accuracy/wrong_solvers.hpp"
#include "odeum/judge/order_fit.hpp"

/// Solvers with and without faults, put through the study of convergence as any other.
namespace odeum::tests {

struct Trial {
  judge::OrderFit fit;
  /// Whether the fault can be seen in the wrong solver's errors alone: among the finer half of the
  /// steps at which the same solver without its fault solves the case to 1 %, where errors are
  /// clear of rounding, they vary beside the right ones by four times, or grow to four times what
  /// they are at the coarsest. (At coarse steps a fault may do harm and vanish with the step.) To a
  /// tolerance the right errors are those at the same mean step, and ten times as much counts.
  bool visible = false;
};
Trial tried(const WrongSolver& solver, const Case& c);

/// Verdicts that do not say that a solver has the order that it claims.
bool denies(judge::Verdict verdict);

/// All with a fault, and those without.
std::vector<WrongSolver> all_wrong();
std::vector<WrongSolver> all_right();

}  // namespace odeum::tests
