// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/backward_differences.hpp"
#include "odeum/methods/rodas5p.hpp"

namespace odeum::methods {

/// Backward differentiation formula (BDF) of order 3, A(86.03 degrees)-stable; started by Rodas5P.
struct bdf3 : BackwardDifferenceMethod<3, rodas5p> {
  static constexpr MethodInfo info = named("bdf3");
};

}  // namespace odeum::methods
