// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace odeum::linear {

/// Preconditioned conjugate gradients for a symmetric positive definite A (Saad, Iterative Methods
/// for Sparse Linear Systems, algorithm 9.1). `apply(x, ax)` and `precondition(r, z)` take arrays
/// of n doubles. On entry x is the guess, on return the solution. False where a direction of
/// negative curvature shows that A is indefinite, after n + 50 iterations, or where `watch`, which
/// sees each iteration, returns false.
class ConjugateGradients {
 public:
  /// What one iteration did, for those who watch.
  struct Iteration {
    const double* x;          ///< after it
    double residual_squared;  ///< of the recurrence, after it
    double alpha, rz;         ///< the length along the direction, and r.z before it
  };
  struct Unwatched {
    bool operator()(const Iteration&) const { return true; }
  };

  explicit ConjugateGradients(std::size_t n) : n_(n), r_(n), z_(n), p_(n), ap_(n) {}

  template <class Apply, class Precondition, class Watch = Unwatched>
  bool solve(Apply&& apply, Precondition&& precondition, const double* b, double* x,
             double relative_tolerance, Watch&& watch = {}) {
    if (dot(x, x) == 0) {
      r_.assign(b, b + n_);
    } else {
      apply(x, ap_.data());
      ++products_;
      for (std::size_t i = 0; i < n_; ++i) r_[i] = b[i] - ap_[i];
    }
    const double target = relative_tolerance * relative_tolerance * dot(b, b);
    if (dot(r_.data(), r_.data()) <= target) return true;
    precondition(r_.data(), z_.data());
    p_ = z_;
    double rz = dot(r_.data(), z_.data());
    for (std::size_t iteration = 0; iteration < n_ + 50; ++iteration) {
      apply(p_.data(), ap_.data());
      ++products_;
      const double curvature = dot(p_.data(), ap_.data());
      if (!(curvature > 0)) return false;
      const double alpha = rz / curvature;
      for (std::size_t i = 0; i < n_; ++i) {
        x[i] += alpha * p_[i];
        r_[i] -= alpha * ap_[i];
      }
      const double residual_squared = dot(r_.data(), r_.data());
      const bool goes_on = watch(Iteration{x, residual_squared, alpha, rz});
      if (residual_squared <= target) return true;
      if (!goes_on) return false;
      precondition(r_.data(), z_.data());
      const double rz_next = dot(r_.data(), z_.data());
      const double beta = rz_next / rz;
      rz = rz_next;
      for (std::size_t i = 0; i < n_; ++i) p_[i] = z_[i] + beta * p_[i];
    }
    return false;
  }

  /// Calls of `apply` by all solves so far.
  std::uint64_t products() const { return products_; }

 private:
  // Sixteen independent sums, since one would be bound by the latency of additions.
  double dot(const double* a, const double* b) const {
    constexpr std::size_t lanes = 16;
    double sums[lanes] = {};
    std::size_t i = 0;
    for (; i + lanes <= n_; i += lanes)
      for (std::size_t k = 0; k < lanes; ++k) sums[k] += a[i + k] * b[i + k];
    for (; i < n_; ++i) sums[0] += a[i] * b[i];
    double sum = 0;
    for (const double part : sums) sum += part;
    return sum;
  }
  std::size_t n_;
  std::vector<double> r_, z_, p_, ap_;
  std::uint64_t products_ = 0;
};

}  // namespace odeum::linear
