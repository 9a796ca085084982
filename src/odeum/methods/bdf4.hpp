// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/backward_differences.hpp"
#include "odeum/methods/rodas5p.hpp"

namespace odeum::methods {

/// Backward differentiation formula (BDF) of order 4, A(73.35 degrees)-stable; started by Rodas5P.
struct bdf4 : BackwardDifferenceMethod<4, rodas5p> {
  static constexpr MethodInfo info = named("bdf4");
};

}  // namespace odeum::methods
