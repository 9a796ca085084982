// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/methods/dormand_prince54.hpp"

namespace odeum::methods {

/// Dormand and Prince's pair 5(4) under proportional-integral control (control/step_control.hpp).
struct dormand_prince54_pi : dormand_prince54 {
  static constexpr MethodInfo info = described({.id = "dormand_prince54_pi",
                                                .control = Control::proportional_integral,
                                                .source = dormand_prince54::info.source});
};

}  // namespace odeum::methods
