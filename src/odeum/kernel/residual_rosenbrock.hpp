// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <utility>

#include "odeum/kernel/residual_system.hpp"
#include "odeum/kernel/rosenbrock.hpp"

namespace odeum {

/// A Rosenbrock method on M y' = f(t, y) with a constant matrix M, stated by its residuals (Hairer,
/// Wanner, Solving ODEs II, VI.4.18): with J = dR/dy each stage solves
///
///     (J + M / (gamma h)) u_i = -R(t + alpha_i h, y + sum a_ij u_j, -sum c_ij u_j / h)
///                               - gamma_i h dR/dt(t, y, 0),
///
/// which on y' = f(t, y) are the stages of Rosenbrock<T, P>. dR/dt is taken by differences of order
/// 4 within the step, so that their error is h^4 in a term of size h.
template <const auto& T, WithResiduals P>
class Rosenbrock<T, P> {
 public:
  static constexpr std::size_t stages = T.stages;

  explicit Rosenbrock(const P& problem)
      : problem_(problem),
        system_(problem),
        rates_(make_state(problem)),
        by_time_(rates_),
        argument_(rates_),
        start_(rates_),
        residual_(rates_) {
    u_.fill(rates_);
  }

  Status step(double t, double h, State<P>& y) {
    if (!solve_stages(t, h, y)) return Status::newton_failed;
    add_row(y, T.m);
    return Status::ok;
  }
  Status step(double t, double h, State<P>& y, State<P>& error) requires(T.embedded()) {
    if (!solve_stages(t, h, y)) return Status::newton_failed;
    auto difference = T.m;
    for (std::size_t i = 0; i < stages; ++i) difference[i] -= T.m_hat[i];
    for (double& component : error) component = 0;
    add_row(error, difference);
    add_row(y, T.m);
    return Status::ok;
  }

 private:
  static constexpr auto alpha = T.row_sums(T.alpha_matrix());
  static constexpr auto gamma = T.row_sums(T.gamma_matrix());

  bool solve_stages(double t, double h, const State<P>& y) {
    for (double& rate : rates_) rate = 0;
    system_.linearise(t, y, rates_);
    if (!system_.factorise(T.gamma * h)) return false;
    differentiate_by_time(t, h, y);
    for (std::size_t i = 0; i < stages; ++i) {
      each_component(y, [&](std::size_t n) {
        double at = y[n], rate = 0;
        for (std::size_t j = 0; j < i; ++j) {
          at += T.a[i][j] * u_[j][n];
          rate -= T.c[i][j] * u_[j][n];
        }
        argument_[n] = at, rates_[n] = rate / h;
      });
      if (i == 0)
        u_[i] = start_;
      else
        problem_.residual(t + alpha[i] * h, argument_.data(), rates_.data(), u_[i].data());
      each_component(y, [&](std::size_t n) { u_[i][n] = -u_[i][n] - gamma[i] * h * by_time_[n]; });
      system_.solve(u_[i].data());
    }
    return true;
  }
  /// At the rates 0: R itself goes to start_. It is taken for independent of time where it is the
  /// same at the middle of the step.
  void differentiate_by_time(double t, double h, const State<P>& y) {
    constexpr std::array<double, 5> weights{-25, 48, -36, 16, -3};
    const double apart = h / 8;
    const auto add = [&](std::size_t k, const State<P>& residual) {
      each_component(
          y, [&](std::size_t n) { by_time_[n] += weights[k] / (12 * apart) * residual[n]; });
    };
    const auto evaluate = [&](std::size_t k, State<P>& residual) {
      problem_.residual(t + static_cast<double>(k) * apart, y.data(), rates_.data(),
                        residual.data());
    };
    for (double& component : by_time_) component = 0;
    evaluate(0, start_);
    evaluate(4, residual_);
    if (residual_ == start_) return;
    add(0, start_), add(4, residual_);
    for (std::size_t k = 1; k < 4; ++k) {
      evaluate(k, residual_);
      add(k, residual_);
    }
  }
  void add_row(State<P>& to, const auto& weights) const {
    each_component(to, [&](std::size_t n) {
      for (std::size_t i = 0; i < stages; ++i) to[n] += weights[i] * u_[i][n];
    });
  }

  const P& problem_;
  ResidualSystem<P> system_;
  State<P> rates_, by_time_, argument_, start_, residual_;
  std::array<State<P>, stages> u_;
};

}  // namespace odeum
