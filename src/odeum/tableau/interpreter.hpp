// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/core/status.hpp"
#include "odeum/linear/dense_lu.hpp"
#include "odeum/problem/function_problem.hpp"
#include "odeum/tableau/dynamic_tableau.hpp"

namespace odeum {

/// Evaluates the formulas of any Runge-Kutta tableau literally, with the nodes that the tableau
/// states:
///
///     k_i = f(t + c_i h, y + h sum_j a_ij k_j),   y <- y + h sum_i b_i k_i.
///
/// Slow and independent of the kernels, which are tested against it. Implicit stages are solved by
/// Newton's method, one by one where no stage depends on a later one, else all together.
class TableauInterpreter {
 public:
  /// Both must outlive the interpreter.
  TableauInterpreter(const DynamicTableau<double>& tableau, const FunctionProblem& problem);

  /// newton_failed where Newton's method for the stages does not converge.
  Status step(double t, double h, std::vector<double>& y);
  /// The same, and `error` = h sum_i (b_i - b_hat_i) k_i; the tableau must have an embedded row.
  Status step(double t, double h, std::vector<double>& y, std::vector<double>& error);

 private:
  Status solve_stages(double t, double h, const std::vector<double>& y);
  Status solve_stage(std::size_t i, double t, double h, const std::vector<double>& y);
  Status solve_together(double t, double h, const std::vector<double>& y);
  /// argument_ = y + h sum_j a_ij k_j
  void form_argument(std::size_t i, double h, const std::vector<double>& y);
  void add(double h, const std::vector<double>& weights, std::vector<double>& y) const;
  double* k(std::size_t i) { return k_.data() + i * n_; }

  const DynamicTableau<double>& tableau_;
  const FunctionProblem& problem_;
  std::size_t n_, s_;
  bool one_by_one_;
  std::vector<double> k_, f_, argument_, jacobian_, residual_;
  linear::DenseLu stage_lu_, all_lu_;
};

}  // namespace odeum
