// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <optional>

#include "odeum/contest/solver.hpp"

namespace odeum::cli {

/// What a user asks of one run.
struct RunSettings {
  std::optional<double> step, tolerance;  ///< one of them
  std::optional<double> until;
};

/// The request for a solver over [t0, until or `horizon`], with the only stop at the end. A step
/// that does not divide it is shrunk, and a remark says so. Throws UsageError for a setting that
/// makes no sense or that the solver does not take.
Request make_request(const RunSettings& settings, double t0, double horizon,
                     const SolverInfo& info);

}  // namespace odeum::cli
