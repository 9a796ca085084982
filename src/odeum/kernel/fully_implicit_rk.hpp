// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include "odeum/harness/outcome.hpp"
#include "odeum/harness/solver.hpp"
#include "odeum/kernel/newton.hpp"
#include "odeum/kernel/stage_transform.hpp"
#include "odeum/linear/complex_inverse.hpp"

namespace odeum {

/// The stages of any fully implicit Runge-Kutta method on any problem with a dense Jacobian:
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
        real_(problem),
        complex_(pairs, linear::ComplexInverse<P::dimension>(size_of(problem))),
        argument_(make_state(problem)) {
    for (auto* states : {&z, &f_}) states->fill(argument_);
    for (auto* states : {&w_re_, &w_im_}) states->fill(argument_);
    sum_re_ = sum_im_ = argument_;
  }

  void linearise(double t, const State<P>& y) { real_.linearise(t, y.data()); }
  /// For the step h, with the Jacobian of the last linearise(); false: it cannot be used.
  bool factorise(double h) {
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

  /// One Newton iteration. `measure(stage, correction of z_stage)` sees every correction.
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

  /// Overwrites x by (I - gamma0 h J)^-1 x, gamma0 the real eigenvalue of A.
  void solve_real(State<P>& x) { real_.solve(x.data()); }

  std::array<State<P>, stages> z;

  static constexpr std::array<double, stages> nodes = [] {
    std::array<double, stages> c{};
    for (std::size_t i = 0; i < stages; ++i) c[i] = T.c(i);
    return c;
  }();

 private:
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
    if (real)
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
  DenseShiftedSolver<P> real_;
  std::vector<linear::ComplexInverse<P::dimension>> complex_;
  State<P> argument_, sum_re_, sum_im_;
  std::array<State<P>, stages> f_;
  std::array<State<P>, pairs + has_real> w_re_, w_im_;
};

/// One step of a fixed size: stages to rounding, y <- y + sum_j (b^T A^-1)_j Z_j.
template <const auto& T, Ode P>
class FullyImplicitRungeKutta {
 public:
  explicit FullyImplicitRungeKutta(const P& problem) : system_(problem) {}

  Status step(double t, double h, State<P>& y) {
    constexpr int max_iterations = 50;
    constexpr double slow_kept = 0.05, slow_fresh = 0.2;
    bool fresh = false;
    for (State<P>& z : system_.z)
      for (double& component : z) component = 0;
    if (h != factored_for_ && !renew(t, h, y, fresh)) return Status::newton_failed;
    system_.transform_guess();
    double last = 0;
    int since_renewal = 0;
    for (int iteration = 0; iteration < max_iterations; ++iteration) {
      double size = 0, largest = max_norm(y);
      system_.iterate(t, h, y, [&](std::size_t i, const State<P>& correction) {
        const double norm = max_norm(correction);
        if (!(norm <= size)) size = norm;  // NaN stays
        largest = std::max(largest, max_norm(system_.z[i]));
      });
      if (!std::isfinite(size)) break;
      if (size <= iteration_tolerance * std::max(largest, smallest_state)) {
        finish(y);
        return Status::ok;
      }
      const double rate = since_renewal > 0 ? size / last : 0;
      last = size;
      ++since_renewal;
      if (rate > (fresh ? slow_fresh : slow_kept)) {
        // At the middle of where the iteration has come to.
        State<P> where = y;
        if (rate < 1)
          for (std::size_t n = 0; n < y.size(); ++n) where[n] += system_.z[T.stages / 2][n];
        if (!renew(t + h / 2, h, where, fresh)) break;
        since_renewal = 0;
      }
    }
    factored_for_ = 0;
    return Status::newton_failed;
  }

 private:
  /// The last stage is the new state.
  static constexpr bool stiffly_accurate = T.a[T.stages - 1] == T.b;

  bool renew(double t, double h, const State<P>& y, bool& fresh) {
    fresh = true;
    system_.linearise(t, y);
    factored_for_ = system_.factorise(h) ? h : 0;
    return factored_for_ == h;
  }

  void finish(State<P>& y) {
    if constexpr (stiffly_accurate) {
      for (std::size_t n = 0; n < y.size(); ++n) y[n] += system_.z[T.stages - 1][n];
    } else {
      static constexpr auto weights = [] {
        // b^T A^-1, by elimination on the transposed A.
        constexpr std::size_t s = T.stages;
        auto m = T.a;
        auto x = T.b;
        for (std::size_t i = 0; i < s; ++i)
          for (std::size_t j = 0; j < s; ++j) m[i][j] = T.a[j][i];
        for (std::size_t k = 0; k < s; ++k)
          for (std::size_t i = 0; i < s; ++i) {
            if (i == k) continue;
            const double factor = m[i][k] / m[k][k];
            for (std::size_t j = k; j < s; ++j) m[i][j] -= factor * m[k][j];
            x[i] -= factor * x[k];
          }
        for (std::size_t i = 0; i < s; ++i) x[i] /= m[i][i];
        return x;
      }();
      for (std::size_t n = 0; n < y.size(); ++n) {
        double sum = 0;
        for (std::size_t j = 0; j < T.stages; ++j) sum += weights[j] * system_.z[j][n];
        y[n] += sum;
      }
    }
  }

  StageSystem<T, P> system_;
  double factored_for_ = 0;
};

/// Fits problems of few unknowns. The stages couple through the whole Jacobian, of which a large
/// problem's own solver has the inverse at real gamma h only.
struct ForFewUnknowns {
  static constexpr std::string_view needs =
      "a dense Jacobian, so 128 unknowns at most: the stages couple through the whole of it";
  template <class P>
  static constexpr bool fits = Ode<P>;
  template <class P>
  static bool fits_problem(const P& problem) {
    return size_of(problem) <= dense_dimension_limit;
  }
};
static_assert(dense_dimension_limit == 128, "as the sentence says");

/// Base of a fully implicit method.
template <const auto& T>
struct FullyImplicitMethod : ForFewUnknowns {
  static constexpr const auto& tableau = T;
  template <class P>
  using Stepper = FullyImplicitRungeKutta<T, P>;
  static double amplification(double re, double im) {
    return std::abs(stability_function(T, {re, im}));
  }
};

}  // namespace odeum
