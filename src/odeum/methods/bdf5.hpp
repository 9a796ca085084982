// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/backward_differences.hpp"
#include "odeum/methods/rodas5p.hpp"

namespace odeum::methods {

/// Backward differentiation formula (BDF) of order 5, A(51.84 degrees)-stable; started by Rodas5P.
struct bdf5 : BackwardDifferenceMethod<5, rodas5p> {
  static constexpr MethodInfo info = named("bdf5");
};

}  // namespace odeum::methods
