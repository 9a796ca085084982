// SPDX-License-Identifier: BSD-3-Clause
#include "odeint/inlined.hpp"

namespace odeum::adapters::odeint {

template void enroll_first_order(const Contest<SharedOde>&, std::vector<Entrant>&);
template void enroll(const Contest<SharedOde>&, std::vector<Entrant>&);

}  // namespace odeum::adapters::odeint
