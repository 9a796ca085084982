// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>

#include "odeum/formula/problem.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// Functions of time and state whose signs select alternatives of a right-hand side. Thread-safe.
struct Conditions {
  std::size_t count = 0;  ///< 0: there are none, or they are not known
  std::function<void(double t, const double* y, double* values)> at = {};
};

/// The conditions of comparisons, abs, sign, floor, min and max in the equations of a text.
Conditions conditions_of(const formula::Problem& problem);
/// The conditions of the text that states the case; none where it is not a text.
Conditions conditions_of(const Case& c);

}  // namespace odeum::cases
