// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>

#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Backward differences of a solution on a uniform grid of times, newest first: [0] is the state,
/// [j] the j-th difference. A change of the step interpolates them to a new grid (Shampine,
/// Reichelt, The MATLAB ODE suite, section 2).
template <int MaxOrder, Ode P>
class DifferenceHistory {
 public:
  explicit DifferenceHistory(const P& problem) { difference_.fill(make_state(problem)); }

  State<P>& operator[](std::size_t j) { return difference_[j]; }
  const State<P>& operator[](std::size_t j) const { return difference_[j]; }

  /// Interpolates to the grid of `factor` times the step, for order k: (R(factor) R(1))^T D.
  void rescale(double factor, std::size_t k) {
    using Matrix = std::array<std::array<double, MaxOrder + 1>, MaxOrder + 1>;
    const auto grid = [k](double ratio) {
      Matrix r{};
      for (std::size_t j = 0; j <= k; ++j) {
        r[0][j] = 1;
        for (std::size_t i = 1; i <= k; ++i)
          r[i][j] = j == 0 ? 0
                           : r[i - 1][j] *
                                 (static_cast<double>(i) - 1 - ratio * static_cast<double>(j)) /
                                 static_cast<double>(i);
      }
      return r;
    };
    const Matrix r = grid(factor), u = grid(1);
    Matrix ru{};
    for (std::size_t i = 0; i <= k; ++i)
      for (std::size_t j = 0; j <= k; ++j)
        for (std::size_t l = 0; l <= k; ++l) ru[i][j] += r[i][l] * u[l][j];
    for (std::size_t n = 0; n < difference_[0].size(); ++n) {
      std::array<double, MaxOrder + 1> column{};
      for (std::size_t j = 0; j <= k; ++j)
        for (std::size_t i = 0; i <= k; ++i) column[j] += ru[i][j] * difference_[i][n];
      for (std::size_t j = 0; j <= k; ++j) difference_[j][n] = column[j];
    }
  }

  /// Appends an accepted step of order k: d is its difference of order k + 1.
  void advance(std::size_t k, const State<P>& d) {
    for (std::size_t n = 0; n < d.size(); ++n) {
      difference_[k + 2][n] = d[n] - difference_[k + 1][n];
      difference_[k + 1][n] = d[n];
      for (std::size_t j = k + 1; j-- > 0;) difference_[j][n] += difference_[j + 1][n];
    }
  }

  /// y <- the polynomial through the last k + 1 states, at `time` of a grid of h that ends at t.
  void interpolate(double time, double t, double h, std::size_t k, State<P>& y) const {
    y = difference_[0];
    double product = 1;
    for (std::size_t j = 1; j <= k; ++j) {
      product *= (time - (t - static_cast<double>(j - 1) * h)) / (static_cast<double>(j) * h);
      for (std::size_t n = 0; n < y.size(); ++n) y[n] += difference_[j][n] * product;
    }
  }

 private:
  std::array<State<P>, MaxOrder + 3> difference_;
};

}  // namespace odeum
