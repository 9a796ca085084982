// SPDX-License-Identifier: BSD-3-Clause
#include "problems/robertson.hpp"
#include "support/inlined.hpp"

namespace odeum::cases::inlined {

std::vector<Entrant> robertson(const Case& c) { return offer<Robertson>(c); }

}  // namespace odeum::cases::inlined
