// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>

namespace odeum {

/// R(t, y, y') = 0, where not every rate can be solved for: constraints of index 1 among the
/// residuals, or rates that cannot be isolated. Its ordinary problem, of the derivatives of the
/// constraints, has the same solution and gives the rates of a consistent start. Thread-safe.
struct ImplicitForm {
  std::size_t dimension = 0;
  /// Fills r, of `dimension`.
  std::function<void(double t, const double* y, const double* rates, double* r)> residual;
  /// Fills j with dR/dy + alpha dR/dy', dense, by rows.
  std::function<void(double t, const double* y, const double* rates, double alpha, double* j)>
      matrix;
};

}  // namespace odeum
