// SPDX-License-Identifier: BSD-3-Clause
#include "problems/pleiades.hpp"
#include "support/inlined.hpp"

namespace odeum::cases::inlined {

std::vector<Entrant> pleiades(const Case& c) { return offer<Pleiades>(c); }

}  // namespace odeum::cases::inlined
