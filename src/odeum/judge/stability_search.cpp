// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/stability_search.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <optional>

#include "odeum/core/numbers.hpp"

namespace odeum::judge {
namespace {

double next_point(double x) {
  const bool fine = x >= search_fine_from && x < search_fine_to;
  return x * (fine ? 1.02 : 1.25);
}

/// The exponent q of growth ~ x^q above the onset, where that law leads down to the growth at the
/// onset itself; none where growth sets in abruptly.
std::optional<double> power_law(double onset, const Growth& at_onset,
                                const std::function<Growth(double)>& growth_at) {
  // The law is determined from two points above the onset, far enough to be clear of the noise.
  constexpr double ratio = 1.5;
  const Growth near = growth_at(onset * ratio), far = growth_at(onset * ratio * ratio);
  if (at_onset.failed() || !(near.log_per_step > near.noise) || !std::isfinite(far.log_per_step))
    return std::nullopt;
  const double factor = far.log_per_step / near.log_per_step;
  if (!(factor > 1)) return std::nullopt;
  // At the onset the growth is known to a factor of a few, and terms of higher order bend the law
  // by as much; an abrupt onset misses it by 1e8 and more.
  constexpr double allowed = 1e3;
  const double predicted = near.log_per_step / factor;
  if (predicted > allowed * at_onset.log_per_step) return std::nullopt;
  return std::log(factor) / std::log(ratio);
}

}  // namespace

LimitFound find_limit(const std::function<Growth(double)>& growth_at) {
  double low = 0, high = search_start;  // bounded up to low; high is the next point to look at
  bool seen_to_decay = false;
  Growth below, above = growth_at(high);
  if (above.failed()) return {nan, true, "fails from the start"};
  while (!above.grows()) {
    seen_to_decay = seen_to_decay || above.decays();
    low = high;
    below = above;
    high = next_point(low);
    if (high > search_end)
      return {std::numeric_limits<double>::infinity(), false,
              fmt::format("bounded at all points up to {:g}", low)};
    above = growth_at(high);
  }
  while (low > 0 && high - low > search_width * std::max(1.0, low)) {
    const double middle = (low + high) / 2;
    const Growth growth = growth_at(middle);
    if (growth.grows()) {
      high = middle;
      above = growth;
    } else {
      low = middle;
      below = growth;
    }
  }
  if (!seen_to_decay)
    if (const auto exponent = power_law(high, above, growth_at))
      return {0, false,
              fmt::format("grows everywhere, as the power {:.1f} from {:.2g} on; less than "
                          "rounding below",
                          *exponent, high)};
  if (low == 0)
    return {0, false, fmt::format("grows at {:g}, the nearest point to zero", search_start)};
  if (above.failed()) return {low, true, "the solver fails beyond"};
  if (below.noise > 1e-6)
    return {low, false,
            fmt::format("growth below {:.1g} a step cannot be told from none", below.noise)};
  return {low, false, ""};
}

}  // namespace odeum::judge
