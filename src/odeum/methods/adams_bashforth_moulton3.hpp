// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/adams.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/methods/cash_karp54.hpp"

namespace odeum::methods {

/// Adams-Bashforth of order 3 as predictor, Adams-Moulton of order 3 as corrector, once (PECE).
struct adams_bashforth_moulton3 : ForAnyProblem {
  static constexpr MethodInfo info{
      .id = "adams_bashforth_moulton3",
      .family = "multistep",
      .order = 3,
      .one_step = false,
      .source =
          "Moulton 1926; Hairer, Norsett, Wanner, Solving ODEs I, (III.1.5), (III.1.9), III.1 "
          "(PECE)"};
  template <class P>
  using Stepper = Adams<3, true, P, cash_karp54::Stepper<P>>;
};

}  // namespace odeum::methods
