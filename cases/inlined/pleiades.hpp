// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "problems/pleiades.hpp"

namespace odeum::cases::inlined {
using pleiades = Pleiades;
}
