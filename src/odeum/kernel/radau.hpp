// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "odeum/kernel/collocation_guess.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/fully_implicit_rk.hpp"
#include "odeum/kernel/kept_jacobian.hpp"
#include "odeum/kernel/scaled_norm.hpp"

namespace odeum {

/// Trial steps of a Radau IIA method with an odd number of stages, for an adaptive run (Solving
/// ODEs II, IV.8): the guess from the last step's collocation polynomial, simplified Newton
/// iteration that stops as soon as convergence cannot be expected, Jacobian and factors kept while
/// it converges fast, and an error estimate of order S filtered by the matrix of the real system.
template <const auto& T, Ode P>
class RadauStepper {
 public:
  static constexpr std::size_t stages = T.stages;
  static_assert(stages % 2 == 1);

  /// `tolerance`: bound on the estimate; `newton_fraction` of it: bound on Newton's remainder.
  RadauStepper(const P& problem, const Tolerance& tolerance, double newton_fraction)
      : problem_(problem),
        error_scale_(tolerance, make_state(problem)),
        system_(problem),
        f0_(make_state(problem)),
        error_(f0_),
        argument_(f0_),
        inverse_scale_(f0_),
        moved_f_(f0_),
        guess_(problem, StageSystem<T, P>::nodes),
        newton_(max_iterations, newton_fraction) {}

  /// y_new and the scaled error of a step of h from (t, y).
  Status step(double t, double h, const State<P>& y, State<P>& y_new, double& norm) {
    if (moved_) {
      problem_.rhs(t, y.data(), f0_.data());
      scale_by(y);
      moved_ = false;
    }
    if (!solve_stages(t, h, y, [&] { guess_(h, y, system_.z); })) return Status::newton_failed;
    each_component(y, [&](std::size_t n) { y_new[n] = y[n] + system_.z[stages - 1][n]; });
    norm = estimate(h, f0_);
    if (norm >= 1 && (first_ || rejected_)) {
      each_component(y, [&](std::size_t n) { argument_[n] = y[n] + error_[n]; });
      problem_.rhs(t, argument_.data(), moved_f_.data());
      norm = estimate(h, moved_f_);
    }
    return Status::ok;
  }

  /// A step of h within the one from y0 that `made` accepted last: y at its share `from` becomes y
  /// at `to`. The iteration begins at the collocation polynomial of that step.
  bool step_inside(const RadauStepper& made, double from, double to, double t, double h,
                   const State<P>& y0, State<P>& y) {
    scale_by(y);
    jacobian_.moved(true);
    const auto guess = [&] {
      for (std::size_t i = 0; i < stages; ++i) {
        made.guess_.at(from + (to - from) * StageSystem<T, P>::nodes[i], system_.z[i]);
        each_component(y, [&](std::size_t n) { system_.z[i][n] += y0[n] - y[n]; });
      }
    };
    if (!solve_stages(t, h, y, guess)) return false;
    each_component(y, [&](std::size_t n) { y[n] += system_.z[stages - 1][n]; });
    return true;
  }
  /// The collocation polynomial of the last accepted step, from y0: order S.
  void polynomial(double share, const State<P>& y0, State<P>& y) const {
    guess_.at(share, y);
    each_component(y, [&](std::size_t n) { y[n] += y0[n]; });
  }

  /// After an accepted step of h.
  void accept(double h) {
    guess_.remember(h, system_.z);
    moved_ = true;
    first_ = rejected_ = false;
    jacobian_.moved(newton_.contraction() > keep_jacobian_below);
  }
  void reject() {
    rejected_ = true;
    jacobian_.renew_unless_fresh();
  }
  /// What Newton's iteration took in the last step, for the control of steps and order.
  int iterations() const { return newton_.iterations(); }
  double contraction() const { return newton_.contraction(); }
  static constexpr int max_iterations = 7 + (static_cast<int>(stages) - 3) * 5 / 2;

 private:
  static constexpr double keep_jacobian_below = 1e-3;

  void scale_by(const State<P>& y) {
    each_component(y,
                   [&](std::size_t n) { inverse_scale_[n] = 1 / error_scale_(n, std::abs(y[n])); });
  }

  template <class Guess>
  bool solve_stages(double t, double h, const State<P>& y, Guess&& guess) {
    // Errors of a state of index k are larger by h^(1 - k) (VII.4).
    if constexpr (requires { problem_.index_of(std::size_t(0)); }) {
      scale_by(y);
      for (std::size_t n = 0; n < y.size(); ++n)
        inverse_scale_[n] *= power(std::min(h, 1.0), problem_.index_of(n) - 1);
    }
    const auto attempt = [&] {
      guess();
      system_.transform_guess();
      newton_.begin();
      return newton_([&] {
        double sum = 0;
        system_.iterate(t, h, y, [&](std::size_t, const State<P>& correction) {
          sum += scaled_squares(correction, inverse_scale_);
        });
        return std::sqrt(sum / static_cast<double>(stages * y.size()));
      });
    };
    return jacobian_.solve(
        h, [&] { system_.linearise(t, y); }, [&](double by) { return system_.factorise(by); },
        attempt);
  }

  /// error_ <- (I - gamma0 h J)^-1 (gamma0 h f + sum e_i z_i), and its norm.
  double estimate(double h, const State<P>& f) {
    const StageTransform& transform = stage_transform<T>();
    const double gamma_h = transform.inverse_mu[0].real() * h;
    each_component(f, [&](std::size_t n) {
      double sum = gamma_h * f[n];
      for (std::size_t i = 0; i < stages; ++i) sum += transform.estimate[i] * system_.z[i][n];
      error_[n] = sum;
    });
    system_.solve_real(error_);
    return scaled_norm(error_, inverse_scale_);
  }

  const P& problem_;
  ErrorScale<State<P>> error_scale_;
  StageSystem<T, P> system_;
  State<P> f0_, error_, argument_, inverse_scale_, moved_f_;
  CollocationGuess<stages, P> guess_;
  // As in RADAU5, but for the remainder that it takes over from the step before.
  SimplifiedNewton<NewtonSettings{.divergent = 0.99, .foresees = true, .smooth = true}> newton_;
  KeptJacobian jacobian_;
  bool moved_ = true, first_ = true, rejected_ = false;
};

}  // namespace odeum
