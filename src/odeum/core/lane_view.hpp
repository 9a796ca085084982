// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>

#include "odeum/core/lanes.hpp"

namespace odeum {

/// A problem behind function pointers whose numbers are Lanes. `problem` points to a pointer to its
/// constants, those of the member in each lane; arrays have `dimension` numbers, the dense
/// row-major Jacobian its square.
struct LaneView {
  using Function = void (*)(const void* problem, const Lanes* t, const Lanes* y, Lanes* f);
  std::size_t dimension = 0, constants = 0;
  Function rhs = nullptr;
  Function jacobian = nullptr, time_derivative = nullptr;  ///< null: none; it is autonomous
  std::shared_ptr<const void> code = nullptr;              ///< keeps the functions
};

}  // namespace odeum
