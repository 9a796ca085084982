// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace odeum::tests {

/// A problem of cases/reference as text.
struct TruthProblem {
  std::string name, reference, text;
  std::size_t states;
  /// What the claimed floor may be, relative to the largest component; 0: anything.
  double relative_floor;
};

/// All of cases/reference but the cloths, which are scenes.
std::vector<TruthProblem> truth_problems();

}  // namespace odeum::tests
