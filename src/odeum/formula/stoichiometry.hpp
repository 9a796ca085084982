// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <map>
#include <vector>

namespace odeum::formula {

/// Numbers by species: of a reaction how many of each it makes, of a sum its weights.
using Weights = std::map<std::uint32_t, long double>;

/// The sums of species that no reaction changes, as whole numbers where these are: a basis of all
/// such sums, in the order of the species, without negative weights where others of the basis can
/// take them away. A species that nothing changes is left out.
std::vector<Weights> conserved_sums(std::uint32_t species, const std::vector<Weights>& reactions);

}  // namespace odeum::formula
