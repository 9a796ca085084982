// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "problems/hires.hpp"
#include "support/inlined_for.hpp"

// The problem's header is plain C++17.
namespace odeum::cases::inlined {
using hires = Hires;
}
