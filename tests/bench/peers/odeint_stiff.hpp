// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17: uBLAS does not compile as C++20 with this Boost.
#include <functional>
#include <vector>

#include "odeum/problem/ode_view.hpp"

namespace odeum::peers {

struct RosenbrockSettings {
  double absolute, relative, first_step;
  bool dense;  ///< rosenbrock4_dense_output, which interpolates the stops before the last
};

/// rosenbrock4 from t0 to each stop, as the library's example has it; the steps made, -1 where the
/// library gives up. `admit` is asked before each evaluation whether there may be more.
long run_rosenbrock4(const OdeView& ode, double t0, const std::vector<double>& stops,
                     const RosenbrockSettings& settings, const std::function<bool()>& admit,
                     std::vector<double>& y);

}  // namespace odeum::peers
