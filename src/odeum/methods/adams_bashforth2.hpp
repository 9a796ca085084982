// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/adams.hpp"
#include "odeum/methods/cash_karp54.hpp"

namespace odeum::methods {

/// Adams-Bashforth of order 2, started by Cash and Karp's method.
struct adams_bashforth2 : AdamsMethod<2, false, cash_karp54> {
  static constexpr MethodInfo info = named("adams_bashforth2");
};

}  // namespace odeum::methods
