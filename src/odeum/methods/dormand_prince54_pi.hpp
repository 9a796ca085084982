// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/explicit_rk.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/methods/dormand_prince54.hpp"

namespace odeum::methods {

/// Dormand and Prince's pair 5(4) under proportional-integral control (control/step_control.hpp).
struct dormand_prince54_pi : ForAnyProblem, ExplicitRungeKuttaMethod<dormand_prince54_tableau> {
  static constexpr MethodInfo info = [] {
    MethodInfo same = dormand_prince54::info;
    same.id = "dormand_prince54_pi";
    same.common_use = CommonUse::none;
    same.control = Control::proportional_integral;
    return same;
  }();
  static constexpr const auto& dense_row = dormand_prince54_dense_row;
};

}  // namespace odeum::methods
