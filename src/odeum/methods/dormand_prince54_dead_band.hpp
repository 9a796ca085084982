// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/methods/dormand_prince54.hpp"

namespace odeum::methods {

/// Dormand and Prince's pair 5(4) under integral control with a dead band
/// (control/step_control.hpp).
struct dormand_prince54_dead_band : dormand_prince54 {
  static constexpr MethodInfo info = described({.id = "dormand_prince54_dead_band",
                                                .control = Control::dead_band,
                                                .source = dormand_prince54::info.source});
};

}  // namespace odeum::methods
