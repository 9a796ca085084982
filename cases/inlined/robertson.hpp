// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "problems/robertson.hpp"

namespace odeum::cases::inlined {
using robertson = Robertson;
}
