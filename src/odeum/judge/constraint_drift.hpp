// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <string>

#include "odeum/solvers/case.hpp"

namespace odeum::judge {

/// The largest magnitude of a constraint along a run, in its own unit.
struct Drift {
  double size = std::numeric_limits<double>::quiet_NaN(), time = size;  ///< NaN: there is none
  std::string name;
};
struct ConstraintDrift {
  Drift given, hidden;
};
/// How far a run is off the constraints of its case at most, at the stops that it reached.
ConstraintDrift drift_off_constraints(const Case& c, const Request& request,
                                      const Outcome& outcome);
/// What is said of it where the index is above 1: a sentence, else empty. `info`: of the solver.
std::string remark_on_drift(const Case& c, const SolverInfo& info, const Request& request,
                            const ConstraintDrift& drift);

}  // namespace odeum::judge
