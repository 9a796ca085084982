// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/spectral_radius.hpp"
#include "odeum/kernel/stabilised_stages.hpp"

/// Explicit Runge-Kutta methods of order 2 and 4 whose stability polynomial has as many stages as
/// the step needs: stable on [-beta(s), 0] with beta growing as s^2. Recurrences of three terms, of
/// Chebyshev's, Legendre's or other orthogonal polynomials, keep rounding small (Hairer, Wanner,
/// Solving ODEs II, IV.2).
namespace odeum {

/// One step of a method with `Rule::stages(count)`, `Rule::count_for(x)`, the stages that are
/// stable up to -x, and `Rule::error_constant`. The spectral radius is estimated at the first step,
/// every 25 steps, and after a step that was rejected. A method of order 4 ends with
/// `Rule::last_stages(count)`. `Rule::last_two_only`: mu + nu = 1 and
/// gamma' = 0 in all stages.
template <class Rule, Ode P>
class StabilisedRungeKutta {
 public:
  explicit StabilisedRungeKutta(const P& problem)
      : problem_(problem),
        radius_of_(problem),
        first_(make_state(problem)),
        last_(first_),
        slope_(first_),
        start_(first_),
        before_(first_) {
    k_.fill(first_);
  }

  Status step(double t, double h, State<P>& y) {
    first_known_ = false;
    make_step(t, h, y);
    return Status::ok;
  }

  /// The error of order 2 is that of the third derivative: 12 (y_n - y_{n+1}) + 6 h (F_n + F_{n+1})
  /// = h^3 y''' + O(h^4).
  Status step(double t, double h, State<P>& y, State<P>& error) {
    make_step(t, h, y);
    problem_.rhs(t + h, y.data(), last_.data());
    if constexpr (four_last) {
      const auto d = ending_->estimate;
      each_component(y, [&](std::size_t i) {
        error[i] = h * (d[0] * k_[0][i] + d[1] * k_[1][i] + d[2] * k_[2][i] + d[3] * k_[3][i] +
                        d[4] * last_[i]);
      });
    } else {
      each_component(y, [&](std::size_t i) {
        error[i] =
            Rule::error_constant * (12 * (start_[i] - y[i]) + 6 * h * (first_[i] + last_[i]));
      });
    }
    return Status::ok;
  }
  void advance() {
    exchange_components(first_, last_);
    first_known_ = true;
  }
  void repeat() {
    first_known_ = true;
    if (steps_left_ < between_estimates - 1) steps_left_ = 0;  // else it is that of this state
  }
  void forget() { first_known_ = false; }

 private:
  static constexpr int between_estimates = 25;
  static constexpr bool four_last = requires { Rule::last_stages(5); };

  void make_step(double t, double h, State<P>& y) {
    if (!first_known_) problem_.rhs(t, y.data(), first_.data());
    if (--steps_left_ < 0) {
      radius_ = radius_of_(t, y, first_);
      steps_left_ = between_estimates - 1;
    }
    const int count = Rule::count_for(h * radius_);
    if (std::exchange(count_, count) != count) {
      stages_ = Rule::stages(count);
      if constexpr (four_last) ending_ = &Rule::last_stages(count);
    }
    start_ = y;
    before_ = y;
    const double start_slope = h * stages_[0].slope;
    each_component(y, [&](std::size_t i) { y[i] += start_slope * first_[i]; });
    for (std::size_t j = 1; j < stages_.size(); ++j) {
      const StabilisedStage s = stages_[j];  // by value: no store below may change it
      problem_.rhs(t + stages_[j - 1].c * h, y.data(), slope_.data());
      const double rest = 1 - s.mu - s.nu, slope = h * s.slope, first_slope = h * s.first_slope;
      each_component(y, [&](std::size_t i) {
        before_[i] = s.mu * y[i] + s.nu * before_[i] + slope * slope_[i];
        if constexpr (!Rule::last_two_only)
          before_[i] += rest * start_[i] + first_slope * first_[i];
      });
      exchange_components(y, before_);
    }
    if constexpr (four_last) make_last_stages(t, h, y);
  }
  void make_last_stages(double t, double h, State<P>& y) {
    before_ = y;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (make_last_stage<I>(t, h, y, std::make_index_sequence<I + 1>{}), ...);
    }
    (std::make_index_sequence<4>{});
  }
  template <std::size_t I, std::size_t... J>
  void make_last_stage(double t, double h, State<P>& y, std::index_sequence<J...>) {
    problem_.rhs(t + ending_->c[I] * h, y.data(), k_[I].data());
    const std::array<double, I + 1> a{h * ending_->a[I + 1][J]...};
    each_component(y, [&](std::size_t n) { y[n] = before_[n] + (... + (a[J] * k_[J][n])); });
  }

  const P& problem_;
  SpectralRadius<P> radius_of_;
  std::vector<StabilisedStage> stages_;
  State<P> first_, last_, slope_, start_, before_;
  std::array<State<P>, four_last ? 4 : 0> k_;
  const LastStages* ending_ = nullptr;
  double radius_ = 0;
  int steps_left_ = 0, count_ = 0;
  bool first_known_ = false;
};

/// A method whose file gives the rule.
template <class Rule>
struct StabilisedMethod : ForAnyProblem {
  template <class P>
  using Stepper = StabilisedRungeKutta<Rule, P>;

  /// |R(z)| with the stages that a step takes where the spectral radius is |z|.
  static double amplification(double re, double im) {
    return stabilised_growth<Rule>(Rule::count_for(1.2 * std::abs(std::complex(re, im))), {re, im});
  }
};

}  // namespace odeum
