// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <vector>

#include "odeum/judge/order_fit.hpp"

namespace odeum::judge {

/// Errors by the first two terms of their expansion, e = C h^p |1 + D h|: for errors whose local
/// slopes still change, so that (log h, log e) is not yet a straight line.
struct TwoTermFit {
  double order = 0;                   ///< p, fitted freely
  double log_factor = 0, second = 0;  ///< log C, and D
  double half_width = 0;              ///< of its 95 % interval
  double scatter = 0;                 ///< root mean square of log e beside the fit
  double second_at_finest = 0;        ///< |D h| at the finest step
  double trend = 0;                   ///< the part of it that neighbouring points share
  std::size_t first = 0, points = 0;  ///< the window

  double at(double step) const {
    return std::exp(log_factor + order * std::log(step)) * std::abs(1 + second * step);
  }
};

/// Over those points at the fine end (or next to it, by up to two) that lie on such a curve and
/// determine p best: at least six, whose scatter is 5 % at most, with no trend, with 1 + D h of one
/// sign and D h at most 1 in size at the finest. None: `points` is 0.
TwoTermFit fit_two_terms(const std::vector<ErrorPoint>& points);

}  // namespace odeum::judge
