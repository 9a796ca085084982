// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/backward_differences.hpp"
#include "odeum/methods/rodas5p.hpp"

namespace odeum::methods {

/// Backward differentiation formula (BDF) of order 2, A-stable; started by Rodas5P.
struct bdf2 : BackwardDifferenceMethod<2, rodas5p> {
  static constexpr MethodInfo info = named("bdf2");
};

}  // namespace odeum::methods
