// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/backward_differences.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/methods/rodas5p.hpp"

namespace odeum::methods {

/// Backward differentiation formula (BDF) of order 5, A(51.84 degrees)-stable; started by Rodas5P.
struct bdf5 : ForAnyProblem {
  static constexpr MethodInfo info{
      .id = "bdf5",
      .family = "multistep",
      .order = 5,
      .one_step = false,
      .source =
          "Curtiss, Hirschfelder 1952; Hairer, Wanner, Solving ODEs II, (V.1.19), V.2 (angles)"};
  template <class P>
  using Stepper = BackwardDifferences<5, P, rodas5p::Stepper<P>>;
};

}  // namespace odeum::methods
