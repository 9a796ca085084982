// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/backward_differences.hpp"
#include "odeum/methods/rodas5p.hpp"

namespace odeum::methods {

/// Backward differentiation formula (BDF) of order 6, A(17.84 degrees)-stable; started by Rodas5P.
struct bdf6 : BackwardDifferenceMethod<6, rodas5p> {
  static constexpr MethodInfo info = named("bdf6");
};

}  // namespace odeum::methods
