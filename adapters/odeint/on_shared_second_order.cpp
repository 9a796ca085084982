// SPDX-License-Identifier: BSD-3-Clause
#include "odeint/inlined.hpp"

namespace odeum::adapters::odeint {

template void add_second_order(Roster<SharedSecondOrder>&);

}  // namespace odeum::adapters::odeint
