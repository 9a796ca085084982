// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>

namespace odeum {

/// What the computation of a truth may take, and how well it has to be known. One that is cut short
/// has what two methods agree on so far, to fewer digits or up to an earlier time, and is not kept.
struct TruthBounds {
  using Moment = std::chrono::steady_clock::time_point;
  Moment until = Moment::max();
  double error = 0;  ///< in the units of the errors; 0: as well as can be
};

}  // namespace odeum
