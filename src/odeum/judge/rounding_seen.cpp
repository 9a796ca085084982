// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/rounding_seen.hpp"

#include <algorithm>
#include <cmath>

namespace odeum::judge {
namespace {

// Errors this many times rounding are clear of it: less bends the local slope of a high order,
// whose steps lie 1.26 apart, by as much as the slopes may differ. Over many components rounding is
// independent of the error, and adds to it by squares.
double clear_of_rounding(const ErrorPoint& point) {
  return std::max(4.0, 10 / std::sqrt(point.components));
}
// What rounding comes to as a rule is known to within this factor.
constexpr double typical_within = 3;

double typical_limit(const ErrorPoint& point) {
  return typical_within * clear_of_rounding(point) * point.typical_rounding();
}

// Of points up to `end`: as far back as errors rise above the finer ones by less than half an
// order's worth.
std::size_t scatter_start(const std::vector<ErrorPoint>& points, std::size_t end,
                          double claimed_order) {
  std::size_t first = end - 1;
  for (double finer = points[first].error; first > 0; --first) {
    const ErrorPoint& coarser = points[first - 1];
    const double ratio = coarser.step / points[first].step;
    if (coarser.error > finer * std::pow(ratio, claimed_order / 2)) break;
    finer = std::max(finer, coarser.error);
  }
  return first;
}

}  // namespace

SeenRounding::SeenRounding(const std::vector<ErrorPoint>& points, double claimed_order) {
  // The finest errors may be small by luck: a few of them are passed over.
  std::size_t first = points.size();
  for (std::size_t lucky = 0; lucky <= points.size() / 6 && lucky + 3 <= points.size(); ++lucky) {
    const std::size_t start = scatter_start(points, points.size() - lucky, claimed_order);
    if (start + lucky + 3 <= points.size()) first = std::min(first, start);
  }
  if (first == points.size()) return;
  double per_root = 0;
  for (std::size_t i = first; i < points.size(); ++i) {
    if (points[i].error > typical_limit(points[i])) return;  // a floor
    per_root = std::max(per_root, points[i].error / std::sqrt(points[i].steps));
  }
  per_root_of_steps_ = per_root;
}

double SeenRounding::limit(const ErrorPoint& point) const {
  const double seen =
      clear_of_rounding(point) * std::max(per_root_of_steps_ * std::sqrt(point.steps), point.floor);
  return std::min(typical_limit(point), seen);
}

}  // namespace odeum::judge
