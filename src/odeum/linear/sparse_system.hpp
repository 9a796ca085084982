// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "odeum/problem/concepts.hpp"
#include "odeum/problem/shifted_solver.hpp"

namespace odeum {

/// Fills the values of a Sparsity at (t, y).
using JacobianEntries = std::function<void(double t, const double* y, double* values)>;

/// The values by forward differences of f. Columns that share no row are moved together (Curtis,
/// Powell, Reid, On the estimation of sparse Jacobian matrices, 1974), so that evaluations are one
/// more than the colours, whatever the number of unknowns. `weights` as in DifferenceIncrements; it
/// and the pattern must outlive the function.
JacobianEntries differenced_entries(const Sparsity& pattern,
                                    std::function<void(double t, const double* y, double* f)> rhs,
                                    const double* weights = nullptr);

/// The colour of each column, from 0. Columns of one colour share no row.
std::vector<int> column_colours(const Sparsity& pattern);

/// Solves with I - g J for a sparse J and several g, real or complex: by an LU factorisation of a
/// band, after the reverse Cuthill-McKee ordering, where that is narrow; of few unknowns by a list
/// of eliminations, where that is shorter; and by Eigen's sparse LU otherwise. The pattern is
/// analysed once.
class SparseSystem {
 public:
  /// `shifts`: how many g, with factors of their own. The pattern must outlive the system. Throws
  /// std::invalid_argument for a pattern that is none.
  SparseSystem(const Sparsity& pattern, JacobianEntries entries, std::size_t shifts);
  ~SparseSystem();

  /// Evaluates J at (t, y); not again where it is that of the last call.
  void linearise(double t, const double* y);
  /// Factorises I - g J of the last linearise(); false where it is singular or not finite. A g
  /// without an imaginary part is solved for in real numbers.
  bool factorise(std::size_t shift, std::complex<double> g);
  /// Overwrites (re, im) by the solution. `im` is null for a real g.
  void solve(std::size_t shift, double* re, double* im);
  /// What it does, in a few words.
  std::string method() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// A problem's solver of one real system.
std::unique_ptr<ShiftedSolver> make_sparse_solver(const Sparsity& pattern, JacobianEntries entries);

/// The problem's own entries, or differences, which count as a Jacobian of a guarded problem too.
/// The problem must outlive the function.
template <WithSparsity P>
JacobianEntries entries_of(const P& problem) {
  if constexpr (WithJacobianEntries<P>) {
    if (offers_jacobian_entries(problem))
      return [&problem](double t, const double* y, double* values) {
        problem.jacobian_entries(t, y, values);
      };
  }
  const auto rhs = [&problem](double t, const double* y, double* f) { problem.rhs(t, y, f); };
  return [&problem,
          entries = differenced_entries(*problem.sparsity(), rhs, difference_weights(problem))](
             double t, const double* y, double* values) {
    if constexpr (requires { problem.watch().count_jacobian(); }) problem.watch().count_jacobian();
    entries(t, y, values);
  };
}

/// Null where the problem states no sparsity.
template <Ode P>
std::unique_ptr<SparseSystem> make_sparse_system([[maybe_unused]] const P& problem,
                                                 [[maybe_unused]] std::size_t shifts) {
  if constexpr (WithSparsity<P>)
    if (problem.sparsity())
      return std::make_unique<SparseSystem>(*problem.sparsity(), entries_of(problem), shifts);
  return nullptr;
}

}  // namespace odeum
