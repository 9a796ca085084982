// SPDX-License-Identifier: BSD-3-Clause
// long: dense and sparse systems of the same stages
#pragma once
#include <algorithm>
#include <array>
#include <complex>
#include <memory>
#include <type_traits>
#include <vector>

#include "odeum/kernel/stage_transform.hpp"
#include "odeum/linear/complex_inverse.hpp"
#include "odeum/linear/dense_system.hpp"
#include "odeum/linear/shifted_solver.hpp"

namespace odeum {

/// The stages of any fully implicit Runge-Kutta method on a problem of few unknowns or with a
/// sparse Jacobian:
///
///     Z_i = h sum_j a_ij f(t + c_j h, y + Z_j)
///
/// by simplified Newton iteration with one Jacobian for all stages, in the variables that decouple
/// them, see StageTransform (Solving ODEs II, IV.8): one real system (I - h/mu J) w = r and a
/// complex one for each pair of eigenvalues mu of the inverse of A, instead of one of S times the
/// size.
template <const auto& T, Ode P>
class StageSystem {
 public:
  static constexpr std::size_t stages = T.stages;
  static constexpr std::size_t pairs = stages / 2;
  static constexpr bool has_real = stages % 2 == 1;

  explicit StageSystem(const P& problem)
      : problem_(problem),
        sparse_(make_sparse_system(problem, pairs + has_real)),
        real_(problem, !sparse_),
        argument_(make_state(problem)) {
    for (std::size_t k = 0; k < pairs && !sparse_; ++k) complex_.emplace_back(size_of(problem));
    for (auto* states : {&z, &f_}) states->fill(argument_);
    for (auto* states : {&w_re_, &w_im_}) states->fill(argument_);
    sum_re_ = sum_im_ = argument_;
  }

  void linearise(double t, const State<P>& y) {
    if (is_sparse())
      sparse_->linearise(t, y.data());
    else
      real_.linearise(t, y.data());
  }
  /// Factorises for the step h, with the Jacobian of the last linearise(); false: singular or not
  /// finite.
  bool factorise(double h) {
    if (is_sparse()) {
      for (std::size_t k = 0; k < pairs + has_real; ++k) {
        std::complex<double> g = h * transform_.inverse_mu[k];
        if (has_real && k == 0) g = g.real();
        if (!sparse_->factorise(k, g)) return false;
      }
      return true;
    }
    if constexpr (has_real)
      if (!real_.factorise(h * transform_.inverse_mu[0].real())) return false;
    for (std::size_t k = 0; k < pairs; ++k)
      if (!complex_[k].factorise(h * transform_.inverse_mu[k + has_real], real_.jacobian().data()))
        return false;
    return true;
  }

  /// To be called when z holds a new guess: W = T^-1 Z.
  void transform_guess() {
    for (std::size_t k = 0; k < pairs + has_real; ++k)
      for (std::size_t n = 0; n < argument_.size(); ++n) {
        double re = 0, im = 0;
        for (std::size_t j = 0; j < stages; ++j) {
          re += transform_.ti[k][j].real() * z[j][n];
          im += transform_.ti[k][j].imag() * z[j][n];
        }
        w_re_[k][n] = re;
        w_im_[k][n] = im;
      }
  }

  /// One Newton iteration. Calls `measure(stage, correction of z_stage)` for every correction.
  template <class Measure>
  void iterate(double t, double h, const State<P>& y, Measure&& measure) {
    for (std::size_t i = 0; i < stages; ++i) {
      for (std::size_t n = 0; n < y.size(); ++n) argument_[n] = y[n] + z[i][n];
      problem_.rhs(t + nodes[i] * h, argument_.data(), f_[i].data());
    }
    for (std::size_t k = 0; k < pairs + has_real; ++k) correct(k, h);
    for (std::size_t i = 0; i < stages; ++i) {
      for (std::size_t n = 0; n < y.size(); ++n) {
        double sum = 0;
        for (std::size_t k = 0; k < pairs + has_real; ++k)
          sum += transform_.t[k][i].real() * w_re_[k][n] - transform_.t[k][i].imag() * w_im_[k][n];
        argument_[n] = sum - z[i][n];
        z[i][n] = sum;
      }
      measure(i, argument_);
    }
  }

  /// Overwrites x by (I - h J / mu)^-1 x, mu the real eigenvalue of the inverse of A, or by the
  /// real part of that with the first complex one: what a stage makes of a change of h f by x.
  void damp(State<P>& x) {
    if constexpr (has_real) {
      solve_real(x);
    } else {
      std::ranges::fill(sum_im_, 0);
      if (is_sparse())
        sparse_->solve(0, x.data(), sum_im_.data());
      else
        complex_[0].solve(x.data(), sum_im_.data());
    }
  }
  /// Overwrites x by (I - gamma0 h J)^-1 x, gamma0 the real eigenvalue of A.
  void solve_real(State<P>& x) {
    if (is_sparse())
      sparse_->solve(0, x.data(), nullptr);
    else
      real_.solve(x.data());
  }

  std::array<State<P>, stages> z;
  /// f at the stages that the last correction moved.
  const std::array<State<P>, stages>& slopes() const { return f_; }

  static constexpr std::array<double, stages> nodes = [] {
    std::array<double, stages> c{};
    for (std::size_t i = 0; i < stages; ++i) c[i] = T.c(i);
    return c;
  }();

 private:
  bool is_sparse() const {
    if constexpr (WithSparsity<P>) return sparse_ != nullptr;
    return false;
  }

  /// w_k <- w_k + (I - g J)^-1 (g (T^-1 F)_k - w_k), g = h / mu_k.
  void correct(std::size_t k, double h) {
    const std::complex<double> g = h * transform_.inverse_mu[k];
    const bool real = has_real && k == 0;
    for (std::size_t n = 0; n < argument_.size(); ++n) {
      double re = 0, im = 0;
      for (std::size_t j = 0; j < stages; ++j) {
        re += transform_.ti[k][j].real() * f_[j][n];
        im += transform_.ti[k][j].imag() * f_[j][n];
      }
      sum_re_[n] = g.real() * re - g.imag() * im - w_re_[k][n];
      sum_im_[n] = g.real() * im + g.imag() * re - w_im_[k][n];
    }
    if (is_sparse())
      sparse_->solve(k, sum_re_.data(), real ? nullptr : sum_im_.data());
    else if (real)
      real_.solve(sum_re_.data());
    else
      complex_[k - has_real].solve(sum_re_.data(), sum_im_.data());
    for (std::size_t n = 0; n < argument_.size(); ++n) {
      w_re_[k][n] += sum_re_[n];
      if (!real) w_im_[k][n] += sum_im_[n];
    }
  }

  const P& problem_;
  const StageTransform& transform_ = stage_transform<T>();
  std::unique_ptr<SparseSystem> sparse_;  // null: the two below
  DenseShiftedSolver<P> real_;
  std::vector<std::conditional_t<linear::BehindPointers<P>, linear::ComplexSystem,
                                 linear::ComplexInverse<P::dimension>>>
      complex_;
  State<P> argument_, sum_re_, sum_im_;
  std::array<State<P>, stages> f_;
  std::array<State<P>, pairs + has_real> w_re_, w_im_;
};

}  // namespace odeum
