// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// By component a power of ten that bounds it at the start and at the stops, which becomes the
/// scale of the case, its truth and its tolerance; `floor`: another floor of the truth. Empty where
/// all are near 1, or the truth is known at no stop. Where states are far from 1 errors and
/// absolute tolerances are meant in such units: an absolute tolerance of 1e-6 controls nothing of a
/// concentration of 1e-7.
std::vector<double> take_proposed_scale(Case& c, double& floor);

/// What people read of it; `states`: the names of the components.
std::pair<std::string, std::string> scale_fact(const std::vector<double>& scale,
                                               const std::vector<std::string>& states);

}  // namespace odeum::cases
