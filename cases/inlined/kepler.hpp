// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "problems/kepler.hpp"

namespace odeum::cases::inlined {
using kepler = Kepler;
}
