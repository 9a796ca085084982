// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <vector>

#include "odeum/core/guarded.hpp"

namespace odeum {

/// The dense Jacobian of a guarded problem for libraries that need one: the problem's own where it
/// has it, else column by column from its Jacobian-vector product, else forward differences (of
/// which each evaluation is counted and guarded as any other).
class DenseJacobian {
 public:
  explicit DenseJacobian(GuardedView& problem) : problem_(problem) {}

  /// Fills j, row-major, dimension x dimension. Returns 0, or 1 when the guard tripped.
  int operator()(double t, const double* y, double* j);

 private:
  GuardedView& problem_;
  std::vector<double> work_;
};

}  // namespace odeum
