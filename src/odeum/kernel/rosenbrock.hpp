// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <optional>
#include <utility>

#include "odeum/core/status.hpp"
#include "odeum/core/tolerance.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/scaled_norm.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/tableau/rosenbrock_tableau.hpp"

namespace odeum {

/// One step of any Rosenbrock method on any problem: a linear system for each stage, all with the
/// same matrix I - gamma h J, J = df/dy(t, y). See tableau/rosenbrock_tableau.hpp for the formula;
/// here it is multiplied by gamma h. A problem without df/dt is assumed autonomous.
template <const auto& T, Ode P>
class Rosenbrock {
 public:
  static constexpr std::size_t stages = T.stages;
  using Real = RealOf<P>;

  explicit Rosenbrock(const P& problem)
      : problem_(problem),
        system_(problem),
        f_(make_state(problem)),
        time_derivative_(f_),
        argument_(f_),
        linearised_at_(f_),
        last_slope_(f_),
        residual_(f_),
        end_slope_(f_) {
    u_.fill(f_);
  }

  Status step(Real t, Real h, State<P>& y) {
    if (!solve_stages(t, h, y)) return Status::newton_failed;
    add_row<Row::main>(y, y, std::make_index_sequence<stages>{});
    return Status::ok;
  }

  /// The same step; `error` becomes sum_i (m_i - m_hat_i) u_i. `newton_failed` too where the
  /// tolerance is known and J does not hold to the end of the step, see holds_at.
  Status step(Real t, Real h, State<P>& y, State<P>& error) requires(T.embedded()) {
    if (!solve_stages(t, h, y)) return Status::newton_failed;
    for (Real& e : error) e = 0;
    add_row<Row::difference>(error, error, std::make_index_sequence<stages>{});
    add_row<Row::main>(y, y, std::make_index_sequence<stages>{});
    if constexpr (corrects_its_end)
      if (scale_ && !holds_at(t + h, T.gamma * h, y, error)) return Status::newton_failed;
    return Status::ok;
  }

  /// The tolerance of the steps to come; without one they are not looked at.
  void solve_to(const Tolerance& tolerance) {
    if constexpr (corrects_its_end) scale_.emplace(tolerance, f_);
  }

  /// Whether the last step was longer than 1 / (gamma lambda) for a growing mode e^(lambda t): it
  /// then decays or changes sign, and a solution that grows to a pole comes out beyond. An even
  /// number of such modes is not seen.
  bool oversteps_growth() const { return system_.negative_determinant(); }

 private:
  static constexpr auto alpha = T.row_sums(T.alpha_matrix());
  static constexpr auto gamma = T.row_sums(T.gamma_matrix());
  // Terms that cancel sum to zero up to rounding.
  static constexpr bool has_time_term(std::size_t i) {
    return gamma[i] > 1e-12 || gamma[i] < -1e-12;
  }
  enum class Row { main, difference };

  /// The last stage is one step of Newton's method from its argument, at the end of the step.
  static constexpr bool corrects_its_end = [] {
    constexpr std::size_t last = stages - 1;
    if (!std::same_as<Real, double> || alpha[last] < 1 - 1e-12 || alpha[last] > 1 + 1e-12)
      return false;
    for (std::size_t j = 0; j < last; ++j)
      if (T.m[j] != T.a[last][j] || T.m_hat[j] != T.m[j]) return false;
    return T.m[last] == 1 && T.m_hat[last] == 0;
  }();

  /// Whether J holds at the end of a step to y at t, whose estimated error is `correction`. That is
  /// the residual of the last stage divided by I - gamma h J: where f leaves a steep slope behind,
  /// as friction does when a body that sticks is torn off, next to nothing is left of any residual,
  /// and the run sticks for long. The residual after the correction, gamma h (f(y) - f - J u), is
  /// zero where J holds. It matters where it is many times the tolerance, and not much smaller than
  /// the one before: Newton's method would not converge by this matrix.
  bool holds_at(Real t, Real gamma_h, const State<P>& y, const State<P>& correction) {
    constexpr double matters = 10, contracts = 0.5;
    double error = 0, before = 0, after = 0;
    const auto enlarge = [&](double& largest, double value, std::size_t i) {
      largest = std::max(largest, std::abs(value) / (*scale_)(i, std::abs(y[i])));
    };
    for (std::size_t i = 0; i < y.size(); ++i) {
      enlarge(error, correction[i], i);
      enlarge(before, residual_[i], i);
    }
    if (!(before > matters) || error > 2)
      return true;  // as for most steps, or the estimate says so
    problem_.rhs(t, y.data(), end_slope_.data());
    for (std::size_t i = 0; i < y.size(); ++i)
      enlarge(after, gamma_h * (end_slope_[i] - last_slope_[i]) - (correction[i] - residual_[i]),
              i);
    return !(after > matters && after > contracts * before);
  }

  bool solve_stages(Real t, Real h, const State<P>& y) {
    // A step that is repeated from the same point (rejected, or halved) keeps f and its
    // derivatives.
    if (!(linearised_ && t == linearised_t_ && y == linearised_at_)) {
      system_.linearise(t, y);
      problem_.rhs(t, y.data(), f_.data());
      if constexpr (NonAutonomous<P>)
        problem_.time_derivative(t, y.data(), time_derivative_.data());
      linearised_t_ = t;
      linearised_at_ = y;
      linearised_ = true;
    }
    return system_.factorise(T.gamma * h) && solve_all(t, h, y, std::make_index_sequence<stages>{});
  }

  template <std::size_t... I>
  bool solve_all(Real t, Real h, const State<P>& y, std::index_sequence<I...>) {
    return (solve_stage<I>(t, h, y, std::make_index_sequence<I>{}) && ...);
  }

  template <std::size_t I, std::size_t... J>
  bool solve_stage(Real t, Real h, const State<P>& y, std::index_sequence<J...>) {
    State<P>& u = u_[I];
    if constexpr (I == 0) {
      u = f_;
    } else if constexpr (((T.a[I][J] == 0) && ...) && alpha[I] == 0) {
      u = f_;
    } else {
      each_component(y, [&](std::size_t n) {
        Real sum = y[n];
        ((T.a[I][J] != 0 ? void(sum += T.a[I][J] * u_[J][n]) : void()), ...);
        argument_[n] = sum;
      });
      problem_.rhs(t + alpha[I] * h, argument_.data(), u.data());
    }
    const Real gamma_h = T.gamma * h;
    if constexpr (corrects_its_end && I + 1 == stages) last_slope_ = u;
    each_component(y, [&](std::size_t n) {
      Real sum = 0;
      ((T.c[I][J] != 0 ? void(sum += (T.gamma * T.c[I][J]) * u_[J][n]) : void()), ...);
      Real slope = u[n];
      if constexpr (NonAutonomous<P> && has_time_term(I))
        slope += gamma[I] * h * time_derivative_[n];
      u[n] = gamma_h * slope + sum;
    });
    if constexpr (corrects_its_end && I + 1 == stages) residual_ = u;
    return system_.solve(u.data());
  }

  template <Row row, std::size_t... I>
  void add_row(const State<P>& from, State<P>& to, std::index_sequence<I...>) const {
    constexpr auto weight = [](std::size_t i) {
      return row == Row::main ? T.m[i] : T.m[i] - T.m_hat[i];
    };
    each_component(to, [&](std::size_t n) {
      Real sum = from[n];
      ((weight(I) != 0 ? void(sum += weight(I) * u_[I][n]) : void()), ...);
      to[n] = sum;
    });
  }

  const P& problem_;
  ShiftedSystem<P> system_;
  State<P> f_, time_derivative_, argument_, linearised_at_;
  State<P> last_slope_, residual_, end_slope_;  ///< of the last stage, and f at the step's end
  std::optional<ErrorScale<State<P>>> scale_;
  std::array<State<P>, stages> u_;
  Real linearised_t_ = 0;
  bool linearised_ = false;
};

/// Base of a Rosenbrock method.
template <const auto& T>
struct RosenbrockMethod {
  static constexpr const auto& rosenbrock_tableau = T;
  template <class P>
  using Stepper = Rosenbrock<T, P>;
  /// |R(z)|: on a linear problem alpha + Gamma is the matrix of a Runge-Kutta method.
  static double amplification(double re, double im) {
    static constexpr auto linear = T.linear_tableau();
    return std::abs(stability_function(linear, {re, im}));
  }
  static constexpr MethodInfo described(MethodInfo info) {
    return completed(info, "linearly_implicit", T);
  }
};

}  // namespace odeum
