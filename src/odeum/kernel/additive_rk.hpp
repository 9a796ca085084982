// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include "odeum/kernel/components.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/newton.hpp"
#include "odeum/problem/implicit_part.hpp"
#include "odeum/tableau/additive_tableau.hpp"

namespace odeum {

/// One step of any additive (IMEX) Runge-Kutta method on y' = f_E(t, y) + f_I(t, y): for each stage
///
///     Y_i = y + h sum_{j<i} (a^E_ij e_j + a^I_ij k_j) + h a^I_ii f_I(t + c_i h, Y_i),
///     e_i = f_E(t + c_i h, Y_i),   k_i = f_I(t + c_i h, Y_i),
///
/// and y <- y + h sum_i (b^E_i e_i + b^I_i k_i). Newton's method solves with the derivative of f_I
/// alone; k_i is taken from the equation (see diagonally_implicit_rk.hpp).
template <const auto& T, Ode P>
class AdditiveRungeKutta {
 public:
  static_assert(T.explicit_half.is_explicit() && T.implicit_half.is_diagonally_implicit());
  static constexpr std::size_t stages = T.stages;

  explicit AdditiveRungeKutta(const P& problem)
      : problem_(problem),
        part_(problem),
        newton_(part_, newton_weight),
        base_(make_state(problem)),
        stage_(base_) {
    e_.fill(base_);
    k_.fill(base_);
  }
  AdditiveRungeKutta(const AdditiveRungeKutta&) = delete;
  AdditiveRungeKutta& operator=(const AdditiveRungeKutta&) = delete;

  static constexpr bool keeps_factors = true;  ///< as long as h is the same
  void will_be_retried() { newton_.will_be_retried(); }
  void solve_to(const Tolerance& tolerance) {
    newton_.solve_to(tolerance, fraction_for_stages<T>(tolerance));
  }

  Status step(double t, double h, State<P>& y) {
    const Status status = solve_stages(t, h, y);
    if (status == Status::ok) add_sum(h, y, T.explicit_half.b, T.implicit_half.b);
    return status;
  }

  /// The same step; `error` becomes the difference to the embedded row.
  Status step(double t, double h, State<P>& y, State<P>& error) requires(T.embedded()) {
    const Status status = solve_stages(t, h, y);
    if (status != Status::ok) return status;
    each_component(error, [&](std::size_t n) { error[n] = 0; });
    add_sum(h, error, T.explicit_half.difference(), T.implicit_half.difference());
    add_sum(h, y, T.explicit_half.b, T.implicit_half.b);
    return Status::ok;
  }

 private:
  using Weights = std::array<double, stages>;

  /// Whether a later stage or a row of weights has a use for f of stage j.
  static constexpr bool is_needed(const Tableau<stages>& half, std::size_t j) {
    if (half.b[j] != 0 || half.b_hat[j] != 0) return true;
    for (std::size_t i = j + 1; i < stages; ++i)
      if (half.a[i][j] != 0) return true;
    return false;
  }
  /// k_i is what Newton's method leaves, divided by h a_ii.
  static constexpr double newton_weight = [] {
    double weight = 1;
    const Tableau<stages>& half = T.implicit_half;
    for (std::size_t i = 0; i < stages; ++i)
      if (half.a[i][i] != 0)
        weight = std::max({weight, half.b[i] / half.a[i][i], -half.b[i] / half.a[i][i]});
    return weight;
  }();

  Status solve_stages(double t, double h, const State<P>& y) {
    for (std::size_t i = 0; i < stages; ++i) {
      base_ = y;
      add_sum(h, base_, T.explicit_half.a[i], T.implicit_half.a[i], i);
      const double gamma_h = h * T.implicit_half.a[i][i], time = t + T.implicit_half.c(i) * h;
      stage_ = base_;
      if (gamma_h != 0) {
        // From the slope of the stage before, where it has one; else from the explicit terms.
        if (i > 0 && is_needed(T.implicit_half, i - 1))
          each_component(stage_, [&](std::size_t n) { stage_[n] += gamma_h * k_[i - 1][n]; });
        const Status status = newton_.solve(time, gamma_h, base_, stage_, base_);
        if (status != Status::ok) return status;
        each_component(y, [&](std::size_t n) { k_[i][n] = newton_.increment()[n] / gamma_h; });
      } else if (is_needed(T.implicit_half, i)) {
        problem_.implicit_part(time, stage_.data(), k_[i].data());
      }
      if (is_needed(T.explicit_half, i)) problem_.explicit_part(time, stage_.data(), e_[i].data());
    }
    return Status::ok;
  }

  /// Adds h times the weighted sum of the first stages.
  void add_sum(double h, State<P>& y, const Weights& of_explicit, const Weights& of_implicit,
               std::size_t count = stages) const {
    each_component(y, [&](std::size_t n) {
      double sum = 0;
      for (std::size_t j = 0; j < count; ++j) {
        if (of_explicit[j] != 0) sum += of_explicit[j] * e_[j][n];
        if (of_implicit[j] != 0) sum += of_implicit[j] * k_[j][n];
      }
      y[n] += h * sum;
    });
  }

  const P& problem_;
  ImplicitPart<P> part_;
  Newton<ImplicitPart<P>> newton_;
  std::array<State<P>, stages> e_, k_;
  State<P> base_, stage_;
};

/// Base of a method that is a pair of tableaus and nothing else.
template <const auto& T>
struct AdditiveMethod {
  static constexpr const auto& additive_tableau = T;
  template <class P>
  using Stepper = AdditiveRungeKutta<T, P>;
  static constexpr MethodInfo described(MethodInfo info) { return completed(info, "imex_rk", T); }
};

}  // namespace odeum
