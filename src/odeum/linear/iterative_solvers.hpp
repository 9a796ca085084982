// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "odeum/linear/preconditioners.hpp"
#include "odeum/linear/sparse_matrix.hpp"

/// Iterative solvers of A x = b for a symmetric positive definite sparse A, from a guess of 0
/// (Saad, Iterative Methods for Sparse Linear Systems, chapters 4 to 6 and 9).
namespace odeum::linear {

struct StopRule {
  double relative_residual = 1e-8;  ///< |b - A x| / |b| at which an iteration ends, Euclidean
  std::size_t most_iterations = 100'000;
};

enum class IterationStatus {
  converged,
  diverged,     ///< the residual has grown a million times
  over_budget,  ///< not converged after most_iterations
  stopped,      ///< by the one who watches
  indefinite,   ///< a direction of no positive curvature: A or M is not positive definite
  non_finite,   ///< b, A or an iterate
};
const char* to_string(IterationStatus status);

struct IterativeOutcome {
  IterationStatus status = IterationStatus::non_finite;
  std::size_t iterations = 0;
  std::vector<double> x;
  std::vector<double> residuals;  ///< |r| / |b| after each iteration, residuals[0] = 1
};

/// Called with the iterate after each iteration; false: no further one.
using Watch = std::function<bool(std::size_t iteration, const double* x)>;

/// x += M^-1 (b - A x). With M = D it is Jacobi's iteration, with a V-cycle multigrid's.
IterativeOutcome stationary(const SparseMatrix& a, const Preconditioner& m,
                            const std::vector<double>& b, const StopRule& rule,
                            const Watch& watch = {});
/// Gauss-Seidel, unknowns in their order. Throws std::invalid_argument where a diagonal entry is 0.
IterativeOutcome gauss_seidel(const SparseMatrix& a, const std::vector<double>& b,
                              const StopRule& rule, const Watch& watch = {});
/// Exact line searches along the residual.
IterativeOutcome steepest_descent(const SparseMatrix& a, const std::vector<double>& b,
                                  const StopRule& rule, const Watch& watch = {});

struct CgOutcome : IterativeOutcome {
  /// Lowest and highest eigenvalue of M^-1 A as far as the iteration has seen them: those of the
  /// tridiagonal matrix of Lanczos' process, which lie within the spectrum and approach its ends.
  double lowest = 0, highest = 0;
};
/// Preconditioned conjugate gradients, see conjugate_gradients.hpp: never more than n + 50
/// iterations. Results are the same bits for any number of threads; m has its own.
CgOutcome preconditioned_cg(const SparseMatrix& a, const Preconditioner& m,
                            const std::vector<double>& b, const StopRule& rule,
                            const Watch& watch = {}, std::size_t threads = 1);

/// Lowest and highest eigenvalue of a symmetric tridiagonal matrix, by bisection with Sturm's
/// sequence (Golub and Van Loan, Matrix Computations, 8.4.1), to the last digits. `off` is one
/// shorter than `diagonal`, which is not empty.
std::pair<double, double> extreme_eigenvalues(const std::vector<double>& diagonal,
                                              const std::vector<double>& off);

}  // namespace odeum::linear
