// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/backward_differences.hpp"
#include "odeum/methods/rodas5p.hpp"

namespace odeum::methods {

/// Backward differentiation formula (BDF) of order 1, L-stable (implicit Euler); started by
/// Rodas5P.
struct bdf1 : BackwardDifferenceMethod<1, rodas5p> {
  static constexpr MethodInfo info = named("bdf1");
};

}  // namespace odeum::methods
