// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/adams.hpp"
#include "odeum/methods/cash_karp54.hpp"

namespace odeum::methods {

/// Adams-Bashforth of order 4 as predictor, Adams-Moulton of order 4 as corrector, once (PECE).
struct adams_bashforth_moulton4 : AdamsMethod<4, true, cash_karp54> {
  static constexpr MethodInfo info = named("adams_bashforth_moulton4");
};

}  // namespace odeum::methods
