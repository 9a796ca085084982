// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>

#include "odeum/judge/growth.hpp"

namespace odeum::judge {

/// The limit of stability along an axis.
struct LimitFound {
  double limit = 0;    ///< infinity: none up to search_end; NaN: the solver fails from the start
  bool fails = false;  ///< the solver fails beyond the limit
  std::string how;     ///< a remark, one sentence; may be empty
};

/// The search looks at points whose distance grows by 2 % between 0.05 and 100, by 25 % below and
/// above: an interval of instability that is narrower may be missed. It ends at 1e6.
inline constexpr double search_start = 1e-3, search_fine_from = 0.05, search_fine_to = 100,
                        search_end = 1e6;
/// The width of the last bisection interval, well below the 1e-6 that a limit is quoted to.
inline constexpr double search_width = 1e-10;

/// The largest x such that a solution stays bounded on all of [0, x], from its growth as a function
/// of x > 0 alone. The first point that grows is bracketed by a scan from zero outwards, and the
/// bracket is bisected.
///
/// A method may grow everywhere, but too little to be measured near zero: |R(iy)| = 1 + y^4/8 + ...
/// for a Runge-Kutta method of order 2 is 1 to rounding below y = 1e-2. So where no point below the
/// onset decays, the onset decides: if growth there continues the power law above it, down to the
/// level of the noise, the law is assumed to hold below it too, and the limit is 0; at a true limit
/// growth starts abruptly, many powers of ten above that law. `growth_at` is called on this thread,
/// with x > 0, and what it throws passes through.
LimitFound find_limit(const std::function<Growth(double)>& growth_at);

}  // namespace odeum::judge
