// SPDX-License-Identifier: BSD-3-Clause
#include "problems/van_der_pol.hpp"
#include "support/inlined.hpp"

namespace odeum::cases::inlined {

std::vector<Entrant> van_der_pol(const Case& c) { return offer<VanDerPol>(c); }

}  // namespace odeum::cases::inlined
