// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <cstddef>
#include <memory>

#include "odeum/problem/concepts.hpp"

namespace odeum::linear {

/// A problem whose functions are behind pointers (problem/shared.hpp): a part of the laboratory,
/// which has what is compiled here, unlike a program that takes the headers alone.
template <class P>
concept BehindPointers = P::dimension == dynamic&& requires(const P& problem) {
  problem.offers_jacobian();
};

/// A dense matrix whose size is known at run time: of 2 to 16 unknowns by the code that is
/// compiled for their number, of more by their entries alone where many are zero. Interface of
/// DenseLu.
class DenseSystem {
 public:
  explicit DenseSystem(std::size_t n);

  /// The n x n entries, row-major: fill them, then call factorise(), which leaves them as they are
  /// or not.
  double* data() { return data_; }
  /// False where the matrix is singular or has an entry that is not finite.
  bool factorise() { return solver_->factorise(); }
  /// Overwrites x (n entries) by the solution.
  void solve(double* x) { solver_->solve(x); }
  /// Whether the determinant of the factorised matrix is negative.
  bool negative_determinant() const { return solver_->negative_determinant(); }

  class Solver {
   public:
    virtual ~Solver() = default;
    virtual double* data() = 0;
    virtual bool factorise() = 0;
    virtual void solve(double* x) = 0;
    virtual bool negative_determinant() = 0;
  };

 private:
  std::unique_ptr<Solver> solver_;
  double* data_;
};

/// The same for I - g J with a complex g. Interface of ComplexInverse.
class ComplexSystem {
 public:
  explicit ComplexSystem(std::size_t n);

  /// `j`: n x n, row-major. False where the matrix is singular or has an entry that is not finite.
  bool factorise(std::complex<double> g, const double* j) { return solver_->factorise(g, j); }
  /// Overwrites (re, im), n entries each, by the solution.
  void solve(double* re, double* im) { solver_->solve(re, im); }

  class Solver {
   public:
    virtual ~Solver() = default;
    virtual bool factorise(std::complex<double> g, const double* j) = 0;
    virtual void solve(double* re, double* im) = 0;
  };

 private:
  std::unique_ptr<Solver> solver_;
};

}  // namespace odeum::linear
