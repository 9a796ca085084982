// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/lane_run.hpp"

#include <algorithm>

#include "odeum/solvers/own_methods.hpp"

namespace odeum {
namespace {

/// Null where the method has no run in lanes.
auto lanes_of(std::string_view method) -> decltype(Solver::lanes) {
  const auto at = std::ranges::find(
      own_methods(), method, [](const Solver& own) -> std::string_view { return own.info.method; });
  return at == own_methods().end() ? nullptr : at->lanes;
}

}  // namespace

bool runs_in_lanes(std::string_view method) { return lanes_of(method) != nullptr; }

LaneRun find_lane_run(std::string_view method, Mode mode, const LaneFamily& family) {
  const auto lanes = lanes_of(method);
  return lanes ? lanes(mode, family) : nullptr;
}

}  // namespace odeum
