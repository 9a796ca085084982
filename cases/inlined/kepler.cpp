// SPDX-License-Identifier: BSD-3-Clause
#include "problems/kepler.hpp"
#include "support/inlined.hpp"

namespace odeum::cases::inlined {

std::vector<Entrant> kepler(const Case& c) { return offer<Kepler>(c); }

}  // namespace odeum::cases::inlined
