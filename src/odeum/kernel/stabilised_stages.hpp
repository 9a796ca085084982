// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

/// Coefficients of the steps of stabilised_rk.hpp.
namespace odeum {

/// One stage of the recurrence,
///
///     Y_j = (1 - mu - nu) y + mu Y_{j-1} + nu Y_{j-2} + h mu' F_{j-1} + h gamma' F_0,
///
/// at t + c h; the first has mu' only.
struct StabilisedStage {
  double mu, nu, slope, first_slope, c;
};

/// Four stages from the state Y that the recurrence ends with,
///
///     k_i = f(t + c_i h, Y + h sum_j a_ij k_j),   y <- Y + h sum_j a_5j k_j,
///
/// and the error estimate h sum_i estimate_i k_i with k_5 = f at the end of the step.
struct LastStages {
  std::array<std::array<double, 4>, 5> a{};
  std::array<double, 5> c{}, estimate{};
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

/// |R(z)| with `count` stages.
template <class Rule>
double stabilised_growth(int count, std::complex<double> z) {
  std::complex<double> before = 1, now = 1;
  bool first = true;
  for (const StabilisedStage& s : Rule::stages(count)) {
    const std::complex<double> next =
        first ? 1.0 + s.slope * z
              : 1 - s.mu - s.nu + s.mu * now + s.nu * before + z * (s.slope * now + s.first_slope);
    before = std::exchange(now, next);
    first = false;
  }
  if constexpr (requires { Rule::last_stages(count); }) {
    std::array<std::complex<double>, 4> k;
    std::complex<double> y = before = now;
    for (std::size_t i = 0; i < 4; ++i) {
      k[i] = z * y;
      y = before;
      for (std::size_t j = 0; j <= i; ++j) y += Rule::last_stages(count).a[i + 1][j] * k[j];
    }
    now = y;
  }
  // Beyond the longest interval terms overflow and cancel.
  return std::isnan(std::abs(now)) ? std::numeric_limits<double>::infinity() : std::abs(now);
}

}  // namespace odeum
