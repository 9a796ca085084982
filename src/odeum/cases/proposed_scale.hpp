// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "odeum/solvers/case.hpp"
#include "odeum/truth/along.hpp"

namespace odeum::cases {

/// Units of a case whose text states none, by what its components are along the solution: of each
/// its largest magnitude, rounded to one digit. A component that falls below a thousandth of that
/// and rises again is measured by its value at each time. 1 for all where no size is far from 1,
/// and none where nothing falls and rises besides. A component that is zero, or the rounding of
/// others, has the size of the largest.
ErrorUnits proposed_units(const truth::Along& along);

/// Makes them those of the case, and where its author asks for no others of its absolute
/// tolerances: one of 1e-6 controls nothing of a concentration of 1e-7.
void take_units(Case& c, const ErrorUnits& units, bool of_tolerances);

/// What people read of them; `states`: the names of the components; `of_tolerances`: whether they
/// are those of absolute tolerances, too.
std::pair<std::string, std::string> units_fact(const ErrorUnits& units,
                                               const std::vector<std::string>& states,
                                               bool of_tolerances);

}  // namespace odeum::cases
