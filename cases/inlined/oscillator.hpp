// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "problems/oscillator.hpp"
#include "support/inlined_for.hpp"

namespace odeum::cases::inlined {
using oscillator = UnitOscillator<false>;
}
