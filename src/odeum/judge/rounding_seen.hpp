// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/judge/order_fit.hpp"

namespace odeum::judge {

/// Rounding as a run shows it, where its finest points only scatter.
class SeenRounding {
 public:
  /// `points`: from coarse to fine.
  SeenRounding(const std::vector<ErrorPoint>& points, double claimed_order);

  /// The error that `point` is clear of rounding above.
  double limit(const ErrorPoint& point) const;

 private:
  double per_root_of_steps_ = 1e300;  ///< rounding grows as the root of the number of steps
};

}  // namespace odeum::judge
