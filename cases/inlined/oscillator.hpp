// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/cases/inlined_for.hpp"
#include "problems/oscillator.hpp"

namespace odeum::cases::inlined {
using oscillator = Oscillator<false, UnitNumbers>;
}
