// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "odeum/core/lane_view.hpp"
#include "odeum/problem/ode_view.hpp"

namespace odeum {

/// A problem for members in lanes, and for one member at a time.
struct LaneFamily {
  LaneView lanes;
  OdeView alone;  ///< the member placed last
  double t0 = 0;
  const std::vector<double>*constants = nullptr, *y0 = nullptr;  ///< of the member placed last
};

/// `count` members; `place(k)` makes member k that placed last, and returns false where its values
/// make no problem. An outcome that is not `ok` only says that the member has to run alone. A
/// LaneRun calls it on its own thread, and returns `count` outcomes in the order of the members.
struct LaneMembers {
  const LaneFamily& family;
  std::size_t count;
  std::function<bool(std::size_t member)> place;
};

}  // namespace odeum
