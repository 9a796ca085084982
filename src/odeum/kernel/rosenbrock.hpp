// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <utility>

#include "odeum/core/status.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/method.hpp"
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
        linearised_at_(f_) {
    u_.fill(f_);
  }

  Status step(Real t, Real h, State<P>& y) {
    if (!solve_stages(t, h, y)) return Status::newton_failed;
    add_row<Row::main>(y, y, std::make_index_sequence<stages>{});
    return Status::ok;
  }

  /// The same step; `error` becomes sum_i (m_i - m_hat_i) u_i.
  Status step(Real t, Real h, State<P>& y, State<P>& error) requires(T.embedded()) {
    if (!solve_stages(t, h, y)) return Status::newton_failed;
    for (Real& e : error) e = 0;
    add_row<Row::difference>(error, error, std::make_index_sequence<stages>{});
    add_row<Row::main>(y, y, std::make_index_sequence<stages>{});
    return Status::ok;
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
    each_component(y, [&](std::size_t n) {
      Real sum = 0;
      ((T.c[I][J] != 0 ? void(sum += (T.gamma * T.c[I][J]) * u_[J][n]) : void()), ...);
      Real slope = u[n];
      if constexpr (NonAutonomous<P> && has_time_term(I))
        slope += gamma[I] * h * time_derivative_[n];
      u[n] = gamma_h * slope + sum;
    });
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
