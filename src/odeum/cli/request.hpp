// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <optional>

#include "odeum/contest/solver.hpp"

namespace odeum::cli {

/// The settings of one run.
struct RunSettings {
  std::optional<double> step, tolerance;  ///< one of them
  std::optional<double> until;
  std::optional<double> every;  ///< between outputs
};

/// The request for a solver over [t0, until or `horizon`], with the only stop at the end. A step
/// that does not divide it is reduced, with a remark. Throws UsageError for an invalid setting or
/// one that the solver does not support.
Request make_request(const RunSettings& settings, double t0, double horizon,
                     const SolverInfo& info);

/// Makes the request ask for states at times `every` apart too (by default at some 500), which do
/// not limit the steps of own adaptive solvers; at a fixed step at the nearest whole steps, with a
/// remark where that is another interval. `numbers`: the size of a state. Throws UsageError for an
/// invalid interval, and where the states are too many to keep.
void ask_for_output(Request& request, const RunSettings& settings, double t0, std::size_t numbers);

}  // namespace odeum::cli
