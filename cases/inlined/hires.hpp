// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/cases/inlined_for.hpp"
#include "problems/hires.hpp"

namespace odeum::cases::inlined {
using hires = Hires;
}
