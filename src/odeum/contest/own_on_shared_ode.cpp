// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/contest/own_solvers.hpp"

namespace odeum {

template void enroll_own(const Contest<SharedOde>&, std::vector<Entrant>&);

}  // namespace odeum
