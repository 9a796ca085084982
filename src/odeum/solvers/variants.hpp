// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>
#include <vector>

namespace odeum {

/// Values for a solver's options (SolverInfo::options).
using Variant = std::map<std::string, double>;

/// What users of a solver's library tune beside its defaults, by the solver's id; as its adapter
/// declares it (adapters/<name>/variants.hpp). Studies of speed run all of it, and the best counts.
std::vector<Variant> variants_of(const std::string& solver);

}  // namespace odeum
