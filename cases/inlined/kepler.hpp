// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/cases/inlined_for.hpp"
#include "problems/kepler.hpp"

namespace odeum::cases::inlined {
using kepler = Kepler;
template <>
inline constexpr bool has_stiff_cases<kepler> = false;
}  // namespace odeum::cases::inlined
