// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <string_view>
#include <vector>

#include "odeum/core/lane_view.hpp"
#include "odeum/core/outcome.hpp"
#include "odeum/problem/ode_view.hpp"
#include "odeum/solvers/solver.hpp"

namespace odeum {

/// A problem for members in lanes, and for one member at a time.
struct LaneFamily {
  LaneView lanes;
  OdeView alone;  ///< the member placed last
  double t0 = 0;
  const std::vector<double>*constants = nullptr, *y0 = nullptr;  ///< of the member placed last
};

/// `count` members; `place(k)` makes member k that placed last, and returns false where its values
/// make no problem. An outcome that is not `ok` only says that the member has to run alone.
struct LaneMembers {
  const LaneFamily& family;
  std::size_t count;
  std::function<bool(std::size_t member)> place;
};

/// Whether an own method has a run in lanes at all.
bool runs_in_lanes(std::string_view method);
/// That of an own method; null where it is not run in lanes in this mode, or needs what the problem
/// does not offer. An explicit method gives a member the bits and the counts that it has alone; a
/// Rosenbrock method its tolerance.
LaneRun find_lane_run(std::string_view method, Mode mode, const LaneFamily& family);

}  // namespace odeum
