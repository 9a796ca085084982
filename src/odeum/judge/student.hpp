// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

namespace odeum::judge {

/// Student's t, 97.5 %, for 1, 2, ... degrees of freedom; 2.1 for many.
constexpr double student_t(std::size_t freedom) {
  constexpr std::array<double, 14> table{12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365,
                                         2.306,  2.262, 2.228, 2.201, 2.179, 2.160, 2.145};
  return freedom <= table.size() ? table[freedom - 1] : 2.1;
}

}  // namespace odeum::judge
