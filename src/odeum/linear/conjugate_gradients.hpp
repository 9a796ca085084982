// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "odeum/core/team.hpp"

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

  /// `team`: its threads share vectors of more than a block; results are the same bits. Null: the
  /// caller alone.
  explicit ConjugateGradients(std::size_t n, Team* team = nullptr)
      : n_(n), team_(team), r_(n), z_(n), p_(n), ap_(n), parts_((n + block - 1) / block) {}

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
      each_block([&](std::size_t begin, std::size_t end) {
        double *r = r_.data(), *p = p_.data(), *ap = ap_.data();
        parts_[begin / block] = sum_over(begin, end, [=](std::size_t i, auto& sum) {
          at(x[i], sum) += alpha * at(p[i], sum);
          at(r[i], sum) -= alpha * at(ap[i], sum);
          sum += at(r[i], sum) * at(r[i], sum);
        });
      });
      const double residual_squared = sum_of_parts();
      const bool goes_on = watch(Iteration{x, residual_squared, alpha, rz});
      if (residual_squared <= target) return true;
      if (!goes_on) return false;
      precondition(r_.data(), z_.data());
      const double rz_next = dot(r_.data(), z_.data());
      const double beta = rz_next / rz;
      rz = rz_next;
      each_block([&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) p_[i] = z_[i] + beta * p_[i];
      });
    }
    return false;
  }

  /// Calls of `apply` by all solves so far.
  std::uint64_t products() const { return products_; }

 private:
  static constexpr std::size_t block = 16384;

  template <class Work>
  void each_block(Work&& work) {
    if (team_)
      team_->run(parts_.size(),
                 [&](std::size_t first, std::size_t end) { run_blocks(work, n_, first, end); });
    else
      run_blocks(work, n_, 0, parts_.size());
  }
  // Never inlined: one compiled function for one thread and for many, so that both round alike.
  template <class Work>
  [[gnu::noinline]] static void run_blocks(Work& work, std::size_t n, std::size_t first,
                                           std::size_t end) {
    for (std::size_t k = first; k < end; ++k) work(k * block, std::min(n, (k + 1) * block));
  }
  double dot(const double* a, const double* b) {
    each_block([&](std::size_t begin, std::size_t end) {
      parts_[begin / block] = sum_over(
          begin, end, [=](std::size_t i, auto& sum) { sum += at(a[i], sum) * at(b[i], sum); });
    });
    return sum_of_parts();
  }
  /// The sum of those of the blocks, in their order.
  double sum_of_parts() const {
    double sum = 0;
    for (const double part : parts_) sum += part;
    return sum;
  }
  using Vector [[gnu::vector_size(4 * sizeof(double))]] = double;
  using Anywhere
      [[gnu::vector_size(4 * sizeof(double)), gnu::aligned(alignof(double)), gnu::may_alias]] =
          double;
  /// The number x, or as many from it on as `like` has.
  static double& at(double& x, const double& /*like*/) { return x; }
  static const double& at(const double& x, const double& /*like*/) { return x; }
  static Anywhere& at(double& x, const Vector& /*like*/) {
    return *reinterpret_cast<Anywhere*>(&x);
  }
  static const Anywhere& at(const double& x, const Vector& /*like*/) {
    return *reinterpret_cast<const Anywhere*>(&x);
  }
  /// `add(i, sum)` adds the term at i, or those at i, i + 1, i + 2 and i + 3. Sixteen independent
  /// sums, since one would be bound by the latency of additions; of plain loops over them g++ 12
  /// makes shuffles.
  template <class Add>
  static double sum_over(std::size_t begin, std::size_t end, Add&& add) {
    Vector sums[4] = {};
    std::size_t i = begin;
    for (; i + 16 <= end; i += 16)
      for (std::size_t k = 0; k < 4; ++k) add(i + 4 * k, sums[k]);
    double sum = sums[0][0];
    for (; i < end; ++i) add(i, sum);
    for (std::size_t k = 1; k < 16; ++k) sum += sums[k / 4][k % 4];
    return sum;
  }
  std::size_t n_;
  Team* team_;
  std::vector<double> r_, z_, p_, ap_, parts_;
  std::uint64_t products_ = 0;
};

}  // namespace odeum::linear
