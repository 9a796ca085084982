// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>

#include "odeum/linear/dense_lu.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/problem/difference_jacobian.hpp"

namespace odeum {

/// A problem's own way to solve (I - gamma_h J(t, y)) x = r, behind function pointers. One object
/// belongs to one solve and keeps its factors between calls.
class ShiftedSolver {
 public:
  virtual ~ShiftedSolver() = default;
  /// Evaluates J at (t, y) and factorises; false where the matrix cannot be used.
  virtual bool factorise(double t, const double* y, double gamma_h) = 0;
  /// Overwrites x = r by the solution.
  virtual bool solve(double* x) = 0;
};

/// The default for few unknowns: a dense LU of the analytic Jacobian, or of forward differences
/// where the problem has none.
template <Ode P>
class DenseShiftedSolver final : public ShiftedSolver {
 public:
  explicit DenseShiftedSolver(const P& problem)
      : problem_(problem), n_(size_of(problem)), lu_(n_) {}

  bool factorise(double t, const double* y, double gamma_h) override {
    double* const m = lu_.data();
    if constexpr (WithJacobian<P>)
      problem_.jacobian(t, y, m);
    else
      difference_jacobian(problem_, t, y, m);
    for (std::size_t i = 0; i < n_ * n_; ++i) m[i] *= -gamma_h;
    for (std::size_t i = 0; i < n_; ++i) m[i * n_ + i] += 1;
    return lu_.factorise();
  }

  bool solve(double* x) override {
    lu_.solve(x);
    return true;
  }

 private:
  const P& problem_;
  std::size_t n_;
  linear::DenseLu lu_;
};

/// The problem's own solver where it offers one, else the dense default.
template <Ode P>
auto make_shifted_solver(const P& problem) {
  if constexpr (WithShiftedSolver<P>) {
    std::unique_ptr<ShiftedSolver> own = problem.shifted_solver();
    if (!own) own = std::make_unique<DenseShiftedSolver<P>>(problem);
    return own;
  } else {
    return std::make_unique<DenseShiftedSolver<P>>(problem);
  }
}

/// The type of what make_shifted_solver returns: a pointer-like handle.
template <Ode P>
using ShiftedSolverOf = decltype(make_shifted_solver(std::declval<const P&>()));

}  // namespace odeum
