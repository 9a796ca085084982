// SPDX-License-Identifier: BSD-3-Clause
#include "problems/oscillator.hpp"
#include "support/inlined.hpp"

namespace odeum::cases::inlined {

std::vector<Entrant> oscillator(const Case& c) { return offer<UnitOscillator<false>>(c); }

}  // namespace odeum::cases::inlined
