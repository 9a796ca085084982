// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/solvers/variants.hpp"

namespace odeum::adapters::bullet {

/// Iterations that users of Bullet tune; alternatives are measured in reports/peers.md.
void add_variants(std::map<std::string, std::vector<Variant>>& all);

}  // namespace odeum::adapters::bullet
