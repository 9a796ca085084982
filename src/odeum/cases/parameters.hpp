// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::cases {

using Values = std::vector<double>;  ///< of the parameters, in their order

/// The case that `make` makes of the given values, which a user may change.
Case with_parameters(std::vector<Parameter> parameters,
                     const std::function<Case(const Values&)>& make);

/// The same for a case whose truth is a reference file, which holds for the parameters as given,
/// and whose equation has the parameters by name: their values are added to it. For other values no
/// truth is known; runs compute one (truth/computed_truth.hpp).
Case with_tabled_parameters(std::vector<Parameter> parameters,
                            const std::function<Case(const Values&)>& make);

/// Throws std::invalid_argument where a value is not positive (is negative).
void require_positive(const std::string& name, double value);
void require_not_negative(const std::string& name, double value);

/// The truth of parameters for which there is neither a closed form nor a table.
Truth unknown_truth(std::string why = "none known for these parameters");

}  // namespace odeum::cases
