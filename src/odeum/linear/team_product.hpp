// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/core/team.hpp"
#include "odeum/linear/sparse_matrix.hpp"

namespace odeum::linear {

/// y = A x by the threads of a team, each some rows.
inline void multiply(const SparseMatrix& a, const double* x, double* y, Team& team) {
  team.run(static_cast<std::size_t>(a.rows), [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first; i < end; ++i) {
      double sum = 0;
      for (int k = a.start[i]; k < a.start[i + 1]; ++k) sum += a.value[k] * x[a.column[k]];
      y[i] = sum;
    }
  });
}

}  // namespace odeum::linear
