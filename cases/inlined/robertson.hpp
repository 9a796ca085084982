// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/cases/inlined_for.hpp"
#include "problems/robertson.hpp"

namespace odeum::cases::inlined {
using robertson = Robertson;
template <>
inline constexpr bool has_nonstiff_cases<robertson> = false;
}  // namespace odeum::cases::inlined
