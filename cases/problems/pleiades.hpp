// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>

#include "odeum/problem/concepts.hpp"

namespace odeum::cases {

/// Seven stars in a plane, star j (from 1) of mass j; y = (x_1..7, y_1..7, then their rates).
struct Pleiades {
  static constexpr std::size_t dimension = 28, stars = 7;
  static constexpr bool velocity_dependent = false;

  template <class R>
  void acceleration(R, const R* q, const R*, R* a) const {
    const R *const x = q, *const y = q + stars;
    for (std::size_t i = 0; i < 2 * stars; ++i) a[i] = 0;
    for (std::size_t i = 0; i < stars; ++i)
      for (std::size_t k = i + 1; k < stars; ++k) {
        const R dx = x[k] - x[i], dy = y[k] - y[i];
        const R r2 = dx * dx + dy * dy;
        const R pull = 1 / (r2 * std::sqrt(r2));
        const R on_i = mass(k) * pull, on_k = mass(i) * pull;
        a[i] += on_i * dx;
        a[stars + i] += on_i * dy;
        a[k] -= on_k * dx;
        a[stars + k] -= on_k * dy;
      }
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 2 * stars, t, y, dydt);
  }
  void jacobian(double, const double* q, double* j) const {
    for (std::size_t i = 0; i < dimension * dimension; ++i) j[i] = 0;
    for (std::size_t i = 0; i < 2 * stars; ++i) j[i * dimension + 2 * stars + i] = 1;
    const double *const x = q, *const y = q + stars;
    for (std::size_t i = 0; i < stars; ++i)
      for (std::size_t k = 0; k < stars; ++k) {
        if (k == i) continue;
        const double dx = x[k] - x[i], dy = y[k] - y[i];
        const double r2 = dx * dx + dy * dy;
        const double pull = mass(k) / (r2 * std::sqrt(r2));
        // d(pull dx)/dx_k and its kin; the row of star i gets it with both signs.
        const double xx = pull * (1 - 3 * dx * dx / r2), yy = pull * (1 - 3 * dy * dy / r2);
        const double xy = -3 * pull * dx * dy / r2;
        const auto add = [&](std::size_t row, std::size_t star_column, double value) {
          j[(2 * stars + row) * dimension + star_column + k] += value;
          j[(2 * stars + row) * dimension + star_column + i] -= value;
        };
        add(i, 0, xx);
        add(i, stars, xy);
        add(stars + i, 0, xy);
        add(stars + i, stars, yy);
      }
  }
  double energy(const double* y) const {
    double sum = 0;
    for (std::size_t i = 0; i < stars; ++i) {
      const double vx = y[14 + i], vy = y[21 + i];
      sum += mass(i) * (vx * vx + vy * vy) / 2;
      for (std::size_t k = 0; k < i; ++k)
        sum -= mass(i) * mass(k) / std::hypot(y[i] - y[k], y[7 + i] - y[7 + k]);
    }
    return sum;
  }
  static double mass(std::size_t star) { return static_cast<double>(star + 1); }
};

}  // namespace odeum::cases
