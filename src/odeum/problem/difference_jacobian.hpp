// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "odeum/problem/concepts.hpp"

namespace odeum {

/// df/dy by forward differences, dense and row-major: dimension + 1 evaluations, each of which a
/// guarded problem counts.
template <Ode P>
void difference_jacobian(const P& problem, double t, const double* y, double* j) {
  const std::size_t n = size_of(problem);
  std::vector<double> f(n), moved(y, y + n), f_moved(n);
  problem.rhs(t, y, f.data());
  const double root_epsilon = std::sqrt(std::numeric_limits<double>::epsilon());
  for (std::size_t k = 0; k < n; ++k) {
    moved[k] = y[k] + root_epsilon * std::max(std::abs(y[k]), 1e-5);
    const double delta = moved[k] - y[k];
    problem.rhs(t, moved.data(), f_moved.data());
    moved[k] = y[k];
    for (std::size_t i = 0; i < n; ++i) j[i * n + k] = (f_moved[i] - f[i]) / delta;
  }
}

/// The problem's own, else by differences.
template <Ode P>
void jacobian_or_differences(const P& problem, double t, const double* y, double* j) {
  if constexpr (WithJacobian<P>)
    if (offers_jacobian(problem)) return void(problem.jacobian(t, y, j));
  difference_jacobian(problem, t, y, j);
}

}  // namespace odeum
