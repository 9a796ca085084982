// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17: uBLAS does not compile as C++20 with this Boost.
#include <vector>

#include "odeum/problem/ode_view.hpp"

namespace odeum::test {

/// integrate_adaptive with rosenbrock4's controller from t0 to each stop, as the library's example
/// has it, with a first step of 1e-6; false after 10,000 steps.
bool rosenbrock4_alone(const OdeView& ode, double t0, const std::vector<double>& stops,
                       double tolerance, std::vector<double>& y);

}  // namespace odeum::test
