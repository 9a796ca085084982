// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <vector>

namespace odeum::linear {

/// Preconditioned conjugate gradients for a symmetric positive definite A (Saad, Iterative Methods
/// for Sparse Linear Systems, algorithm 9.1). `apply(x, ax)` and `precondition(r, z)` take arrays
/// of n doubles. On entry x is the guess, on return the solution. False where a direction of
/// negative curvature shows that A is indefinite, or after n + 50 iterations.
class ConjugateGradients {
 public:
  explicit ConjugateGradients(std::size_t n) : n_(n), r_(n), z_(n), p_(n), ap_(n) {}

  template <class Apply, class Precondition>
  bool solve(Apply&& apply, Precondition&& precondition, const double* b, double* x,
             double relative_tolerance) {
    apply(x, ap_.data());
    for (std::size_t i = 0; i < n_; ++i) r_[i] = b[i] - ap_[i];
    const double target = relative_tolerance * relative_tolerance * dot(b, b);
    if (dot(r_.data(), r_.data()) <= target) return true;
    precondition(r_.data(), z_.data());
    p_ = z_;
    double rz = dot(r_.data(), z_.data());
    for (std::size_t iteration = 0; iteration < n_ + 50; ++iteration) {
      apply(p_.data(), ap_.data());
      const double curvature = dot(p_.data(), ap_.data());
      if (!(curvature > 0)) return false;
      const double alpha = rz / curvature;
      for (std::size_t i = 0; i < n_; ++i) {
        x[i] += alpha * p_[i];
        r_[i] -= alpha * ap_[i];
      }
      if (dot(r_.data(), r_.data()) <= target) return true;
      precondition(r_.data(), z_.data());
      const double rz_next = dot(r_.data(), z_.data());
      const double beta = rz_next / rz;
      rz = rz_next;
      for (std::size_t i = 0; i < n_; ++i) p_[i] = z_[i] + beta * p_[i];
    }
    return false;
  }

 private:
  double dot(const double* a, const double* b) const {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i) sum += a[i] * b[i];
    return sum;
  }
  std::size_t n_;
  std::vector<double> r_, z_, p_, ap_;
};

}  // namespace odeum::linear
