// SPDX-License-Identifier: BSD-3-Clause
#include "odeint/inlined.hpp"

namespace odeum::adapters::odeint {

template void enroll(const Contest<SharedSeparable>&, std::vector<Entrant>&);

}  // namespace odeum::adapters::odeint
