// SPDX-License-Identifier: BSD-3-Clause
// Kinks and jumps of a right-hand side where conditions of its text change.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "odeum/why/path.hpp"

namespace odeum::why {
namespace {

/// How f bends around a change; nothing where it is smooth there, since the alternatives do not
/// differ in this state.
std::optional<Kink> kink_at(const Path& path, double t, double wide,
                            const std::vector<double>& sizes) {
  const auto bend = [&](double by) {
    const std::vector<double> below = path.slope(t - by), middle = path.slope(t),
                              above = path.slope(t + by);
    std::vector<double> bends(middle.size());
    for (std::size_t i = 0; i < bends.size(); ++i)
      bends[i] = std::abs(above[i] - 2 * middle[i] + below[i]) /
                 std::max({std::abs(below[i]), std::abs(middle[i]), std::abs(above[i]), 1e-300});
    return std::pair(bends, middle);
  };
  constexpr double ratio = 64;
  const auto [far, f] = bend(wide);
  const std::vector<double> near = bend(wide / ratio).first;
  if (!is_finite(far.data(), far.size()) || !is_finite(near.data(), near.size())) return {};
  constexpr double rounding = 1e6 * epsilon;
  // Among the components that bend beyond rounding, takes the one whose rate bends most, relative
  // to its size.
  std::optional<std::size_t> most;
  double largest = 0;
  for (std::size_t i = 0; i < near.size(); ++i) {
    const double moved = near[i] * std::abs(f[i]) / (sizes[i] > 0 ? sizes[i] : 1);
    if (near[i] > rounding && (!most || moved > largest)) largest = moved, most = i;
  }
  if (!most) return {};
  const std::size_t component = *most;
  const double power = std::log(far[component] / near[component]) / std::log(ratio);
  if (power > 1.35) return {};
  const std::vector<double> below = path.slope(t - wide), above = path.slope(t + wide);
  const double size =
      std::max({std::abs(below[component]), std::abs(f[component]), std::abs(above[component])});
  return Kink{t, component, power < 0.35, near[component] * size, 2 * wide / ratio};
}

}  // namespace

Moment ahead_of(const Case& c, const Moment& from, double by) {
  Moment ahead = from;
  const std::vector<double> f = slope(c, from.t, from.y);
  for (std::size_t i = 0; i < f.size(); ++i) ahead.y[i] += by * f[i];
  ahead.t += by;
  return ahead;
}

Changed kinks_of_conditions(const Case& c, const cases::Conditions& conditions,
                            std::vector<Moment> moments, double wide, bool ahead,
                            const std::vector<double>& sizes) {
  Changed found;
  if (conditions.count == 0) return found;
  std::erase_if(moments, [](const Moment& at) { return !is_finite(at.y.data(), at.y.size()); });
  if (moments.empty() || moments.size() + ahead < 2) return found;
  if (ahead) moments.push_back(ahead_of(c, moments.back(), wide));
  const Path path(c, moments);
  const std::vector<double> times = times_along(path, moments);
  const std::vector<Change> changes = changes_along(path, conditions, times);
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const double t = changes[k].after;
    double apart = infinity;
    if (k > 0) apart = std::min(apart, t - changes[k - 1].after);
    if (k + 1 < changes.size()) apart = std::min(apart, changes[k + 1].after - t);
    if (!(apart > 0)) continue;
    const auto kink = kink_at(path, t, std::min(0.01 * wide, 0.25 * apart), sizes);
    if (!kink) continue;
    found.kinks.push_back(*kink);
    if (!kink->jump) continue;
    const std::vector<double> y = path.state(changes[k].before);
    found.stays =
        holds_the_solution(c, conditions, changes[k].before, y, changes[k].condition, sizes);
    if (!found.stays) continue;
    for (const double later : times) {
      found.until = later;
      if (later > t &&
          !holds_the_solution(c, conditions, later, path.state(later), changes[k].condition, sizes))
        break;
    }
    return found;
  }
  return found;
}

}  // namespace odeum::why
