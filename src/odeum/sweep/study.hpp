// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "odeum/sweep/sweep.hpp"

namespace odeum::sweep {

struct StudyWishes {
  std::string solver;         ///< library/method; for advice empty, or a glob
  bool quick_orders = false;  ///< orders at fewer step sizes
  double error = 0;           ///< of advice
  double seconds = 0;         ///< of advice or times of a member
};

/// - `converge`: the order of the solver at fixed steps, or in the tolerance where it has none, and
///   the least error of its runs; the status is `ok` where there is an order, else the verdict.
/// - `precision`: its least time to the errors 1e-3, 1e-6 and 1e-9, in nanoseconds.
/// - `advise`: which solver, at which setting, has the error in the least time.
/// Null for another name.
std::shared_ptr<const MemberStudy> member_study(const std::string& name, const StudyWishes& wishes);

}  // namespace odeum::sweep
