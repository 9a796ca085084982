// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/cases/inlined_for.hpp"
#include "problems/van_der_pol.hpp"

namespace odeum::cases::inlined {
using van_der_pol = VanDerPol;
}
