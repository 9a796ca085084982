// SPDX-License-Identifier: BSD-3-Clause
#include "problems/hires.hpp"
#include "support/inlined.hpp"

namespace odeum::cases::inlined {

std::vector<Entrant> hires(const Case& c) { return offer<Hires>(c); }

}  // namespace odeum::cases::inlined
