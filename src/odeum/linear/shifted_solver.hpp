// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>
#include <type_traits>

#include "odeum/linear/dense_system.hpp"
#include "odeum/linear/small_inverse.hpp"
#include "odeum/linear/sparse_system.hpp"
#include "odeum/linear/square_matrix.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/problem/difference_jacobian.hpp"
#include "odeum/problem/shifted_solver.hpp"

namespace odeum {

/// The default for few unknowns: dense, of the analytic Jacobian or of forward differences where
/// the problem has none. The Jacobian is stored apart from its factors, so that it can be
/// factorised for several gamma_h.
template <Ode P>
class DenseShiftedSolver final : public ShiftedSolver {
 public:
  /// `used`: without it no memory is taken, and nothing may be called.
  explicit DenseShiftedSolver(const P& problem, bool used = true)
      : problem_(problem),
        n_(used ? size_of(problem) : 0),
        j_(linear::make_square<P::dimension>(n_)),
        solver_(n_) {}

  void linearise(double t, const State<P>& y) { linearise(t, y.data()); }
  void linearise(double t, const double* y) { jacobian_or_differences(problem_, t, y, j_.data()); }
  bool factorise(double gamma_h) {
    double* const m = solver_.data();
    for (std::size_t i = 0; i < n_ * n_; ++i) m[i] = -gamma_h * j_[i];
    for (std::size_t i = 0; i < n_; ++i) m[i * n_ + i] += 1;
    return solver_.factorise();
  }
  bool factorise(double t, const double* y, double gamma_h) override {
    linearise(t, y);
    return factorise(gamma_h);
  }

  bool solve(double* x, double = exact) override {
    solver_.solve(x);
    return true;
  }

  /// Whether det(I - gamma_h J) is known to be negative.
  bool negative_determinant() const {
    if constexpr (requires { solver_.negative_determinant(); })
      return solver_.negative_determinant();
    return false;
  }

  /// Row-major, as of the last linearise().
  const linear::Square<P::dimension>& jacobian() const { return j_; }

 private:
  /// One that is not used has no size.
  using DenseSolver = std::conditional_t<linear::BehindPointers<P>, linear::DenseSystem,
                                         linear::DenseSolver<P::dimension>>;

  const P& problem_;
  std::size_t n_;
  linear::Square<P::dimension> j_;
  DenseSolver solver_;
};

/// The problem's own solver, or that of its sparse Jacobian; null: neither.
template <Ode P>
std::unique_ptr<ShiftedSolver> make_structured_solver([[maybe_unused]] const P& problem) {
  if constexpr (WithShiftedSolver<P>)
    if (std::unique_ptr<ShiftedSolver> own = problem.shifted_solver()) return own;
  if constexpr (WithSparsity<P>)
    if (problem.sparsity()) return make_sparse_solver(*problem.sparsity(), entries_of(problem));
  return nullptr;
}

template <class P>
concept MayHaveStructure = WithShiftedSolver<P> || WithSparsity<P>;

/// The problem's own solver where it offers one, else the sparse or the dense default.
template <Ode P>
auto make_shifted_solver(const P& problem) {
  if constexpr (MayHaveStructure<P>) {
    std::unique_ptr<ShiftedSolver> own = make_structured_solver(problem);
    if (!own) own = std::make_unique<DenseShiftedSolver<P>>(problem);
    return own;
  } else {
    return std::make_unique<DenseShiftedSolver<P>>(problem);
  }
}

/// What make_shifted_solver returns: a pointer-like handle.
template <Ode P>
using ShiftedSolverOf = decltype(make_shifted_solver(std::declval<const P&>()));

/// The problem's own solver where it offers one, else the dense default, with the functions of
/// DenseShiftedSolver. A problem's own solver evaluates the Jacobian when it factorises, for which
/// the point of `linearise` is stored.
template <Ode P>
class StructuredSystem {
 public:
  explicit StructuredSystem(const P& problem) : own_(make_structured_solver(problem)) {
    if (!own_) dense_ = std::make_unique<DenseShiftedSolver<P>>(problem);
  }
  void linearise(double t, const State<P>& y) {
    if (dense_) return dense_->linearise(t, y.data());
    t_ = t;
    y_ = y;
  }
  bool factorise(double gamma_h) {
    return dense_ ? dense_->factorise(gamma_h) : own_->factorise(t_, y_.data(), gamma_h);
  }
  bool solve(double* x, double relative = ShiftedSolver::exact) {
    return dense_ ? dense_->solve(x) : own_->solve(x, relative);
  }
  bool negative_determinant() const { return dense_ && dense_->negative_determinant(); }

 private:
  std::unique_ptr<ShiftedSolver> own_;
  std::unique_ptr<DenseShiftedSolver<P>> dense_;
  double t_ = 0;
  State<P> y_{};
};

namespace detail {
/// The system for a type of numbers.
template <class Real>
struct SystemIn {
  template <Ode P>
  using type = std::conditional_t<MayHaveStructure<P>, StructuredSystem<P>, DenseShiftedSolver<P>>;
};
}  // namespace detail

/// Solves (I - gamma_h J) x = r by the problem's own solver or the default, in two parts:
/// `linearise` evaluates the Jacobian at (t, y), `factorise` takes gamma_h and may be called again
/// alone. Members in lanes have a solver in lanes (lane_system.hpp).
template <Ode P>
using ShiftedSystem = typename detail::SystemIn<RealOf<P>>::template type<P>;

}  // namespace odeum
