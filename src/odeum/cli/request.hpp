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
};

/// The request for a solver over [t0, until or `horizon`], with the only stop at the end. A step
/// that does not divide it is reduced, with a remark. Throws UsageError for an invalid setting or
/// one that the solver does not support.
Request make_request(const RunSettings& settings, double t0, double horizon,
                     const SolverInfo& info);

}  // namespace odeum::cli
