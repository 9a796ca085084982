// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/adams.hpp"
#include "odeum/methods/cash_karp54.hpp"

namespace odeum::methods {

/// Adams-Bashforth of order 5 as predictor, Adams-Moulton of order 5 as corrector, once (PECE).
struct adams_bashforth_moulton5 : AdamsMethod<5, true, cash_karp54> {
  static constexpr MethodInfo info = named("adams_bashforth_moulton5");
};

}  // namespace odeum::methods
