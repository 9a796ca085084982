// SPDX-License-Identifier: BSD-3-Clause
#include "odeint/inlined.hpp"

namespace odeum::adapters::odeint {

template void enroll(const Contest<SharedSecondOrder>&, std::vector<Entrant>&);

}  // namespace odeum::adapters::odeint
