// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/backward_differences.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/methods/rodas5p.hpp"

namespace odeum::methods {

/// Backward differentiation formula (BDF) of order 1, L-stable (implicit Euler); started by
/// Rodas5P.
struct bdf1 : ForAnyProblem {
  static constexpr MethodInfo info{
      .id = "bdf1",
      .family = "multistep",
      .order = 1,
      .one_step = true,
      .source =
          "Curtiss, Hirschfelder 1952; Hairer, Wanner, Solving ODEs II, (V.1.19), V.2 (angles)"};
  template <class P>
  using Stepper = BackwardDifferences<1, P, rodas5p::Stepper<P>>;
};

}  // namespace odeum::methods
