// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/dense_jacobian.hpp"

#include <algorithm>

#include "odeum/problem/difference_jacobian.hpp"

namespace odeum {

int DenseJacobian::operator()(double t, const double* y, double* j) {
  if (problem_.view().jacobian) return problem_.jacobian(t, y, j);
  if (problem_.guard().tripped()) return 1;
  problem_.guard().count_jacobian();
  const std::size_t n = problem_.view().dimension;
  work_.resize(3 * n);
  double *const a = work_.data(), *const b = a + n;
  if (!problem_.view().jacobian_times) {
    const auto rhs = [this](double time, const double* at, double* f) {
      return problem_.rhs(time, at, f) == 0;
    };
    return difference_jacobian(rhs, n, t, y, j, {a, b, b + n}, problem_.guard().weights()) ? 0 : 1;
  }
  double *const unit = a, *const column = b;
  std::fill(unit, unit + n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    unit[k] = 1;
    if (problem_.jacobian_times(t, y, unit, column) != 0) return 1;
    unit[k] = 0;
    for (std::size_t i = 0; i < n; ++i) j[i * n + k] = column[i];
  }
  return 0;
}

}  // namespace odeum
