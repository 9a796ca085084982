// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/adams.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/methods/cash_karp54.hpp"

namespace odeum::methods {

/// Adams-Bashforth of order 3, started by Cash and Karp's method.
struct adams_bashforth3 : ForAnyProblem {
  static constexpr MethodInfo info{
      .id = "adams_bashforth3",
      .family = "multistep",
      .order = 3,
      .one_step = false,
      .source = "Bashforth, Adams 1883; Hairer, Norsett, Wanner, Solving ODEs I, (III.1.5)"};
  template <class P>
  using Stepper = Adams<3, false, P, cash_karp54::Stepper<P>>;
};

}  // namespace odeum::methods
