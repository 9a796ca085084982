// SPDX-License-Identifier: BSD-3-Clause
// long: on right-hand sides and on residuals
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "odeum/core/status.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/difference_history.hpp"
#include "odeum/kernel/kept_jacobian.hpp"
#include "odeum/kernel/residual_system.hpp"
#include "odeum/kernel/scaled_norm.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/tableau/ndf_coefficients.hpp"

namespace odeum {

/// Steps of the numerical differentiation formulas of orders 1 to 5 (Shampine, Reichelt, The MATLAB
/// ODE suite, SIAM J. Sci. Comput. 18 (1997) 1-22, section 2), on a grid of equal steps: the method
/// stores backward differences of the solution and interpolates them to another grid when the step
/// changes. `tolerance` is that of the scaled norms.
template <Ode P>
class BdfStepper {
 public:
  static constexpr int max_order = ndf::max_order, max_iterations = 4;

  BdfStepper(const P& problem, double t0, const State<P>& y0, double h, const Tolerance& tolerance)
      : problem_(problem),
        level_(tolerance, y0),
        system_(problem),
        h_(h),
        newton_(max_iterations, newton_tolerance(tolerance.relative)),
        difference_(problem) {
    for (State<P>* state : {&y_, &psi_, &d_, &f_, &scale_, &middle_, &middle_slope_})
      *state = make_state(problem);
    difference_[0] = y0;
    problem.rhs(t0, y0.data(), difference_[1].data());
    for (double& component : difference_[1]) component *= h;
  }

  /// Solves for the state at t_new = t + h by order k; newton_failed where that does not converge.
  /// Nothing has moved before advance().
  Status solve(double t_new, int k) {
    const auto order = static_cast<std::size_t>(k);
    const double alpha = (1 - ndf::kappa[order]) * ndf::gamma[order];
    each_component(y_, [&](std::size_t n) {
      double predicted = difference_[0][n], psi = 0;
      for (std::size_t j = 1; j <= order; ++j) {
        predicted += difference_[j][n];
        psi += ndf::gamma[j] * difference_[j][n];
      }
      y_[n] = predicted;
      d_[n] = 0;
      psi_[n] = psi / alpha;
      scale_[n] = 1 / level_(n, std::abs(predicted));
    });
    return converge(t_new, h_ / alpha) ? Status::ok : Status::newton_failed;
  }
  /// Newton iterations of the last solve(), and its scaled error.
  int iterations() const { return newton_.iterations(); }
  double error(int k) const { return std::abs(ndf::error_constant(k)) * norm(d_); }

  /// Whether f at the middle of the step from t that was solved for is the slope of the cubic
  /// through the states and slopes at its ends, to some tolerances of the state; not looked at on
  /// residuals.
  bool even_in_the_middle(double t, int k) {
    if constexpr (WithResiduals<P>) {
      return true;
    } else {
      constexpr double even = 30;
      const auto order = static_cast<std::size_t>(k);
      const double c = h_ / ((1 - ndf::kappa[order]) * ndf::gamma[order]);
      const State<P>& start = difference_[0];
      State<P>& at_start = middle_slope_;
      State<P>& at = middle_;
      problem_.rhs(t, start.data(), at_start.data());
      each_component(at, [&](std::size_t n) {
        const double at_end = (psi_[n] + d_[n]) / c;
        at[n] = 0.5 * (start[n] + y_[n]) + 0.125 * h_ * (at_start[n] - at_end);
        f_[n] = 1.5 * (y_[n] - start[n]) - 0.25 * h_ * (at_start[n] + at_end);
      });
      State<P>& there = at_start;
      problem_.rhs(t + 0.5 * h_, at.data(), there.data());
      each_component(at, [&](std::size_t n) { f_[n] = h_ * there[n] - f_[n]; });
      if (norm(f_) <= even) return true;
      return system_.solve(f_.data()) && norm(f_) <= even;
    }
  }
  /// Makes the step by order k that was solved for.
  void advance(int k) {
    jacobian_.moved(false);
    difference_.advance(static_cast<std::size_t>(k), d_);
  }
  /// After a step by order k: what order k - 1 (> 0) or k + 1 would have as its scaled error.
  double error_of_lower(int k) const {
    return std::abs(ndf::error_constant(k - 1)) * norm(difference_[static_cast<std::size_t>(k)]);
  }
  double error_of_higher(int k) const {
    return std::abs(ndf::error_constant(k + 1)) *
           norm(difference_[static_cast<std::size_t>(k) + 2]);
  }

  double h() const { return h_; }
  /// h <- factor h, with the k differences of the order k.
  void rescale(double factor, int k) {
    difference_.rescale(factor, static_cast<std::size_t>(k));
    h_ *= factor;
  }
  const State<P>& state() const { return difference_[0]; }
  /// The state at `time` of the last step, which ended at t, by the polynomial of order k.
  void interpolate(double time, double t, int k, State<P>& y) const {
    difference_.interpolate(time, t, h_, static_cast<std::size_t>(k), y);
  }

 private:
  /// Not below rounding: of a correction, and on residuals of their terms, which a correction
  /// multiplies by the inverse of the matrix.
  static double newton_tolerance(double relative) {
    constexpr double roundings = WithResiduals<P> ? 1000 : 10;
    return std::max(roundings * std::numeric_limits<double>::epsilon() / relative,
                    std::min(0.03, std::sqrt(relative)));
  }

  /// Newton on d = y - predicted: d = c f(t, y) - psi, psi the weighted differences; on residuals
  /// R(t, y, (psi + d) / c) = 0.
  bool converge(double t_new, double c) {
    const auto factorise = [&](double gamma_h) {
      const bool regular = system_.factorise(gamma_h);
      if (!regular) jacobian_.moved(true);  // the next attempt predicts another state
      return regular;
    };
    const auto correct = [&] {
      if constexpr (WithResiduals<P>) {
        each_component(y_, [&](std::size_t n) { f_[n] = (psi_[n] + d_[n]) / c; });
        system_.correct(t_new, y_, f_);
      } else {
        problem_.rhs(t_new, y_.data(), f_.data());
        each_component(y_, [&](std::size_t n) { f_[n] = c * f_[n] - psi_[n] - d_[n]; });
        if (!system_.solve(f_.data())) return newton_.no_solution;
      }
      each_component(y_, [&](std::size_t n) {
        y_[n] += f_[n];
        d_[n] += f_[n];
      });
      return norm(f_);
    };
    return jacobian_.solve(
        c, [&] { system_.linearise(t_new, y_); }, factorise,
        [&] {
          guess();
          newton_.begin();
          return newton_(correct);
        });
  }

  /// The prediction y - d. Components whose sign differs from the state's start from the state
  /// instead: their Newton iteration could converge to another solution, or overshoot a decay to
  /// zero.
  void guess() {
    each_component(y_, [&](std::size_t n) {
      const double predicted = y_[n] - d_[n], state = difference_[0][n];
      y_[n] = predicted * state < 0 ? state : predicted;
      d_[n] = y_[n] - predicted;
    });
  }

  double norm(const State<P>& x) const { return scaled_norm(x, scale_); }

  const P& problem_;
  ErrorScale<State<P>> level_;
  std::conditional_t<WithResiduals<P>, ResidualSystem<P>, ShiftedSystem<P>> system_;
  double h_;
  // As in ode15s, but a first correction never suffices unless it is zero.
  SimplifiedNewton<NewtonSettings{.foresees = true, .first_remainder = NewtonSettings::never}>
      newton_;
  KeptJacobian jacobian_;
  State<P> y_, psi_, d_, f_, scale_;
  State<P> middle_, middle_slope_;
  DifferenceHistory<max_order, P> difference_;
};

}  // namespace odeum
