// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>
#include <vector>

#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/kernel/spectral_radius.hpp"

/// Explicit Runge-Kutta methods of order 2 whose stability polynomial has as many stages as the
/// step needs: stable on [-beta(s), 0] with beta growing as s^2. Three-term recurrences of
/// Chebyshev's or Legendre's polynomials keep rounding small (Hairer, Wanner, Solving ODEs II,
/// IV.2).
namespace odeum {

/// One stage of the recurrence,
///
///     Y_j = (1 - mu - nu) y + mu Y_{j-1} + nu Y_{j-2} + h mu' F_{j-1} + h gamma' F_0,
///
/// at t + c h; the first has mu' only.
struct StabilisedStage {
  double mu, nu, slope, first_slope, c;
};

/// The stages of polynomials b_j P_j(w0 + w1 z) + 1 - b_j P_j(w0), where P_j follows from its
/// recurrence P_j(x) = p_j x P_{j-1} - q_j P_{j-2}. `b(j)`, `value(j)` = P_j(w0).
template <class B, class Value, class Recurrence>
std::vector<StabilisedStage> stages_of(int count, double w0, double w1, const B& b,
                                       const Value& value, const Recurrence& recurrence) {
  std::vector<StabilisedStage> stages{{0, 0, b(1) * w1, 0, b(1) * w1}};
  for (int j = 2; j <= count; ++j) {
    const auto [p, q] = recurrence(j);
    const double before = b(j) / b(j - 1);
    StabilisedStage stage{p * w0 * before, -q * b(j) / b(j - 2), p * w1 * before, 0, 0};
    stage.first_slope = -(1 - b(j - 1) * value(j - 1)) * stage.slope;
    // On y' = 1 every stage is exact at its own time.
    stage.c = stage.mu * stages.back().c + stage.slope + stage.first_slope +
              (j > 2 ? stage.nu * stages[static_cast<std::size_t>(j) - 3].c : 0);
    stages.push_back(stage);
  }
  return stages;
}

/// One step of a method with `Rule::stages(count)`, `Rule::count_for(x)`, the stages that are
/// stable up to -x, and `Rule::error_constant`. The spectral radius is estimated at the first step,
/// every 25 steps, and after a step that was rejected.
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
        before_(first_) {}

  Status step(double t, double h, State<P>& y) {
    first_known_ = false;
    make_step(t, h, y);
    return Status::ok;
  }

  /// The error is that of the third derivative: 12 (y_n - y_{n+1}) + 6 h (F_n + F_{n+1}) = h^3 y'''
  /// + O(h^4).
  Status step(double t, double h, State<P>& y, State<P>& error) {
    make_step(t, h, y);
    problem_.rhs(t + h, y.data(), last_.data());
    each_component(y, [&](std::size_t i) {
      error[i] = Rule::error_constant * (12 * (start_[i] - y[i]) + 6 * h * (first_[i] + last_[i]));
    });
    return Status::ok;
  }
  void advance() {
    exchange_components(first_, last_);
    first_known_ = true;
  }
  void repeat() {
    first_known_ = true;
    steps_left_ = 0;
  }

 private:
  void make_step(double t, double h, State<P>& y) {
    if (!first_known_) problem_.rhs(t, y.data(), first_.data());
    if (steps_left_-- <= 0) {
      constexpr int between_estimates = 25;
      radius_ = radius_of_(t, y, first_);
      steps_left_ = between_estimates;
    }
    const int count = Rule::count_for(h * radius_);
    if (count != static_cast<int>(stages_.size())) stages_ = Rule::stages(count);
    start_ = y;
    before_ = y;
    each_component(y, [&](std::size_t i) { y[i] += h * stages_[0].slope * first_[i]; });
    for (std::size_t j = 1; j < stages_.size(); ++j) {
      const StabilisedStage& s = stages_[j];
      problem_.rhs(t + stages_[j - 1].c * h, y.data(), slope_.data());
      const double rest = 1 - s.mu - s.nu, slope = h * s.slope, first_slope = h * s.first_slope;
      each_component(y, [&](std::size_t i) {
        before_[i] = rest * start_[i] + s.mu * y[i] + s.nu * before_[i] + slope * slope_[i] +
                     first_slope * first_[i];
      });
      exchange_components(y, before_);
    }
  }

  const P& problem_;
  SpectralRadius<P> radius_of_;
  std::vector<StabilisedStage> stages_;
  State<P> first_, last_, slope_, start_, before_;
  double radius_ = 0;
  int steps_left_ = 0;
  bool first_known_ = false;
};

/// A method whose file gives the rule.
template <class Rule>
struct StabilisedMethod : ForAnyProblem {
  template <class P>
  using Stepper = StabilisedRungeKutta<Rule, P>;

  /// |R(z)| with the stages that a step takes where the spectral radius is |z|.
  static double amplification(double re, double im) {
    const std::complex<double> z(re, im);
    std::complex<double> before = 1, now = 1;
    bool first = true;
    for (const StabilisedStage& s : Rule::stages(Rule::count_for(1.2 * std::abs(z)))) {
      const std::complex<double> next = first ? 1.0 + s.slope * z
                                              : 1 - s.mu - s.nu + s.mu * now + s.nu * before +
                                                    z * (s.slope * now + s.first_slope);
      before = std::exchange(now, next);
      first = false;
    }
    // Beyond the longest interval terms overflow and cancel.
    return std::isnan(std::abs(now)) ? std::numeric_limits<double>::infinity() : std::abs(now);
  }
};

}  // namespace odeum
