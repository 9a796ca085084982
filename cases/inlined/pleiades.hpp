// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/cases/inlined_for.hpp"
#include "problems/pleiades.hpp"

namespace odeum::cases::inlined {
using pleiades = Pleiades;
template <>
inline constexpr bool has_stiff_cases<pleiades> = false;
}  // namespace odeum::cases::inlined
