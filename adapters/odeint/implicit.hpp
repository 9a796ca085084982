// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17: uBLAS of Boost 1.74 does not compile as C++20.
#include <vector>

#include "odeum/core/outcome.hpp"
#include "odeum/problem/ode_view.hpp"

/// The steppers that solve linear systems with uBLAS.
namespace odeum::adapters::odeint {

using ImplicitRun = Outcome (*)(const OdeView& view, double t0, const std::vector<double>& y0,
                                const Request& request);

Outcome run_implicit_euler(const OdeView& view, double t0, const std::vector<double>& y0,
                           const Request& request);
Outcome run_rosenbrock4(const OdeView& view, double t0, const std::vector<double>& y0,
                        const Request& request);
Outcome run_rosenbrock4_dense_output(const OdeView& view, double t0, const std::vector<double>& y0,
                                     const Request& request);

}  // namespace odeum::adapters::odeint
