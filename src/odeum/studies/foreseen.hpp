// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/core/request.hpp"

/// What a solve will cost, by the costs of coarser settings.
namespace odeum::study {

/// The cost of a solve, in the units of a budget.
struct Cost {
  double setting;  ///< number of steps, or 1 / tolerance
  double work;
};

/// A lower bound of the next setting's cost, extrapolated from the last ones; 0 where unknown.
double foreseen_work(const std::vector<Cost>& coarser, const Request& next);

}  // namespace odeum::study
