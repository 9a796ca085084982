// SPDX-License-Identifier: BSD-3-Clause
// long: the stages, their matrices and their rounding share all members
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "odeum/kernel/residual_system.hpp"
#include "odeum/kernel/stage_system.hpp"
#include "odeum/problem/function_problem.hpp"

namespace odeum {

/// The stages of a fully implicit Runge-Kutta method on residuals,
///
///     R(t + c_i h, y + Z_i, K_i) = 0,   K = (A^-1 x I) Z / h,
///
/// by the same simplified Newton iteration as on y' = f(t, y). With J = dR/dy, M = dR/dy' at its
/// start and A^-1 = T diag(mu) T^-1 the equations of W = T^-1 Z fall into a system with the matrix
/// J + mu_k/h M for each eigenvalue, of two conjugates for one (Hairer, Wanner, Solving ODEs II,
/// IV.8 and VI.1). A residual without rates is a constraint; the matrices are regular where the
/// index is 1.
template <const auto& T, WithResiduals P>
class StageSystem<T, P> {
 public:
  static constexpr std::size_t stages = T.stages;
  static constexpr const auto& nodes = StageSystem<T, FunctionProblem>::nodes;

  explicit StageSystem(const P& problem)
      : problem_(problem),
        n_(size_of(problem)),
        systems_(count, linear::Lu<Complex>(n_)),
        argument_(n_),
        rates_(n_),
        j_(n_ * n_),
        m_(n_ * n_),
        terms_(n_),
        sum_(n_) {
    z.fill(argument_);
    r_.fill(argument_);
    w_.fill(sum_);
  }

  void linearise(double t, const State<P>& y) {
    problem_.rhs(t, y.data(), rates_.data());
    problem_.matrix(t, y.data(), rates_.data(), 0, j_.data());
    problem_.matrix(t, y.data(), rates_.data(), 1, m_.data());
    for (std::size_t i = 0; i < n_ * n_; ++i) m_[i] -= j_[i];
    std::fill(terms_.begin(), terms_.end(), 0);
    for (std::size_t i = 0; i < n_ * n_; ++i) terms_[i / n_] += std::abs(j_[i] * y[i % n_]);
  }
  /// Factors for the step h, with J and M of the last linearise(); false: singular or not finite.
  bool factorise(double h) {
    for (std::size_t k = 0; k < count; ++k) {
      const Complex by = mu(k) / h;
      for (std::size_t i = 0; i < n_ * n_; ++i) systems_[k].data()[i] = j_[i] + by * m_[i];
      if (!systems_[k].factorise()) return false;
    }
    filter_ = mu(0).real() / h;
    find_rounding();
    return true;
  }

  /// To be called when z holds a new guess: W = T^-1 Z.
  void transform_guess() {
    for (std::size_t k = 0; k < count; ++k) into(k, z, w_[k]);
  }

  /// One Newton iteration. Calls `measure(stage, correction of z_stage)` for every correction. At
  /// equal steps components that are rounding are 0 in it; to a tolerance they tell the
  /// contraction.
  template <class Measure>
  void iterate(double t, double h, const State<P>& y, Measure&& measure) {
    for (std::size_t i = 0; i < stages; ++i) {
      for (std::size_t n = 0; n < n_; ++n) {
        argument_[n] = y[n] + z[i][n];
        rates_[n] = 0;
        for (std::size_t k = 0; k < count; ++k) rates_[n] += part(i, k, n, mu(k) / h);
      }
      problem_.residual(t + nodes[i] * h, argument_.data(), rates_.data(), r_[i].data());
    }
    for (std::size_t k = 0; k < count; ++k) {
      into(k, r_, sum_);
      systems_[k].solve(sum_.data());
      for (std::size_t n = 0; n < n_; ++n) w_[k][n] -= sum_[n];
    }
    for (std::size_t i = 0; i < stages; ++i) {
      for (std::size_t n = 0; n < n_; ++n) {
        double now = 0;
        for (std::size_t k = 0; k < count; ++k) now += part(i, k, n, 1);
        argument_[n] = now - z[i][n];
        z[i][n] = now;
        if (problem_.to_rounding() && std::abs(argument_[n]) <= rounding_[i][n]) argument_[n] = 0;
      }
      measure(i, argument_);
    }
  }

  /// Overwrites x by (J + M / (gamma0 h))^-1 M x / (gamma0 h), gamma0 the real eigenvalue of A:
  /// what (I - gamma0 h df/dy)^-1 x is where the rates can be solved for.
  void solve_real(State<P>& x) {
    for (std::size_t i = 0; i < n_; ++i) {
      sum_[i] = 0;
      for (std::size_t k = 0; k < n_; ++k) sum_[i] += filter_ * m_[i * n_ + k] * x[k];
    }
    systems_[0].solve(sum_.data());
    for (std::size_t i = 0; i < n_; ++i) x[i] = sum_[i].real();
  }

  std::array<State<P>, stages> z;

 private:
  using Complex = std::complex<double>;
  using Row = std::vector<Complex>;
  static constexpr std::size_t count = (stages + 1) / 2;

  Complex mu(std::size_t k) const { return 1.0 / transform_.inverse_mu[k]; }
  /// (T^-1 x)_k.
  void into(std::size_t k, const std::array<State<P>, stages>& x, Row& row) const {
    for (std::size_t n = 0; n < n_; ++n) {
      row[n] = 0;
      for (std::size_t j = 0; j < stages; ++j) row[n] += transform_.ti[k][j] * x[j][n];
    }
  }
  /// What rounding of y + Z makes of a correction at most: a steep constraint magnifies it.
  void find_rounding() {
    rounding_.fill(State<P>(n_));
    for (std::size_t k = 0; k < count; ++k) {
      double unit = 0;
      for (const auto& factor : transform_.ti[k])
        unit += std::numeric_limits<double>::epsilon() * std::abs(factor);
      for (std::size_t n = 0; n < n_; ++n) sum_[n] = unit * terms_[n];
      systems_[k].solve(sum_.data());
      for (std::size_t i = 0; i < stages; ++i)
        for (std::size_t n = 0; n < n_; ++n)
          rounding_[i][n] += std::abs(transform_.t[k][i] * sum_[n]);
    }
  }
  /// What w_k, times a factor, gives to component n of stage i.
  double part(std::size_t i, std::size_t k, std::size_t n, Complex factor) const {
    return (transform_.t[k][i] * factor * w_[k][n]).real();
  }

  const P& problem_;
  const StageTransform& transform_ = stage_transform<T>();
  std::size_t n_;
  std::vector<linear::Lu<Complex>> systems_;
  State<P> argument_, rates_;
  std::vector<double> j_, m_, terms_;  ///< terms: |J| |y|
  Row sum_;
  std::array<State<P>, stages> r_, rounding_;
  std::array<Row, count> w_;
  double filter_ = 0;
};

}  // namespace odeum
