// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cmath>
#include <numbers>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/set_problem.hpp"

namespace odeum::cases {
namespace {

constexpr int side = 30;
constexpr double width = side + 1;  // distances of places in a unit

/// Differences of the second order on the inner places of a square, zero at its edges.
struct Heat2d {
  static constexpr std::size_t dimension = dynamic;
  static constexpr double c = width * width;
  Sparsity pattern;

  Heat2d() {
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        std::vector<int> row{i * side + j};
        if (i > 0) row.push_back((i - 1) * side + j);
        if (j > 0) row.push_back(i * side + j - 1);
        if (j + 1 < side) row.push_back(i * side + j + 1);
        if (i + 1 < side) row.push_back((i + 1) * side + j);
        pattern.add_row(row);
      }
  }
  static std::size_t size() { return side * side; }
  void rhs(double, const double* y, double* f) const {
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j) {
        const double* const at = y + i * side + j;
        const double around = (i > 0 ? at[-side] : 0) + (j > 0 ? at[-1] : 0) +
                              (j + 1 < side ? at[1] : 0) + (i + 1 < side ? at[side] : 0);
        f[i * side + j] = c * (around - 4 * at[0]);
      }
  }
  const Sparsity* sparsity() const { return &pattern; }
  void jacobian_entries(double, const double*, double* values) const {
    for (int i = 0; i < side * side; ++i)
      for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
        values[k] = pattern.column[k] == i ? -4 * c : c;
  }
};

/// Amplitude and numbers of half waves: eigenvectors of the differences.
struct Wave {
  double amplitude;
  int m, n;
};
constexpr std::array<Wave, 3> waves{{{1, 1, 1}, {0.5, 3, 2}, {0.25, 7, 11}}};

double decay_rate(const Wave& wave) {
  const auto part = [](int m) {
    const double s = std::sin(m * std::numbers::pi / (2 * width));
    return 4 * Heat2d::c * s * s;
  };
  return part(wave.m) + part(wave.n);
}

void exact_state(double t, double* y) {
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      double sum = 0;
      for (const Wave& wave : waves)
        sum += wave.amplitude * std::exp(-decay_rate(wave) * t) *
               std::sin(wave.m * std::numbers::pi * (i + 1) / width) *
               std::sin(wave.n * std::numbers::pi * (j + 1) / width);
      y[i * side + j] = sum;
    }
}

Case make_heat_2d() {
  Case c;
  c.nature.linear = c.nature.stiff = true;
  c.equation =
      "y_ij' = 961 (y_{i-1,j} + y_{i+1,j} + y_{i,j-1} + y_{i,j+1} - 4 y_ij), i, j = 1..30, zero "
      "beyond; y(0) = three eigenvectors: sin sin of (1, 1), (3, 2) and (7, 11) half waves with "
      "amplitudes 1, 1/2, 1/4";
  c.source =
      "Hairer, Wanner, Solving ODEs II, IV.1; Iserles, A First Course in the Numerical "
      "Analysis of Differential Equations, chapters 8 and 16";
  c.y0.resize(Heat2d::size());
  exact_state(0, c.y0.data());
  c.stops = {0.01, 0.02, 0.05};
  c.settings.steps_multiple = 5;
  c.settings.coarsest_steps = 20;
  c.settings.finest_steps = 640;
  c.settings.evaluation_budget = 20'000;
  c.truth.source = "closed form: eigenvectors of the differences decay apart";
  c.truth.closed_form = true;
  // Rounding of y0, of sines and of exponents of up to 9, each of a few in the last digit.
  c.truth.floor = 4e-15;
  c.truth.at = [](double t, double* y) {
    exact_state(t, y);
    return true;
  };
  set_problem(c, Heat2d());
  return c;
}

}  // namespace

/// Heat in a square plate: 900 unknowns, linear and stiff; a band would have 30 on either side.
std::vector<Statement> heat_2d() {
  return {
      {.id = "heat_2d", .title = "Heat in a plate", .tags = {"diffusion"}, .make = make_heat_2d}};
}

}  // namespace odeum::cases
