// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/proposed_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace odeum::cases {
namespace {

double power_above(double size) { return std::pow(10, std::ceil(std::log10(size) - 1e-9)); }

std::vector<double> proposed_scale(const Case& c) {
  std::vector<double> largest(c.y0.size()), state(c.y0.size());
  const auto extend = [&](const std::vector<double>& y) {
    for (std::size_t i = 0; i < y.size(); ++i) largest[i] = std::max(largest[i], std::abs(y[i]));
  };
  extend(c.y0);
  bool known = false;
  for (const double stop : c.stops)
    if (c.truth.at(stop, state.data())) {
      known = true;
      extend(state);
    }
  const double of_all = *std::ranges::max_element(largest);
  if (!known || !(of_all > 0) || !std::isfinite(of_all)) return {};
  for (double& size : largest) {
    // A state that is zero at all of these times has the size of the largest.
    size = power_above(size > 0 ? size : of_all);
    // The truth's own error is to be small in these units as well.
    if (c.truth.floor > 0) size = std::max(size, power_above(1e8 * c.truth.floor));
  }
  const auto near_one = [](double size) { return size >= 0.01 && size <= 100; };
  if (std::ranges::all_of(largest, near_one)) return {};
  return largest;
}

}  // namespace

std::vector<double> take_proposed_scale(Case& c, double& floor) {
  std::vector<double> scale = proposed_scale(c);
  if (scale.empty()) return scale;
  const double smallest = *std::ranges::min_element(scale);
  c.truth.floor /= smallest;
  floor /= smallest;
  c.tolerance = Tolerance::of_thresholds(c.tolerance.relative, scale);
  c.scale = scale;
  return scale;
}

std::pair<std::string, std::string> scale_fact(const std::vector<double>& scale,
                                               const std::vector<std::string>& states) {
  constexpr std::size_t few = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(few, scale.size()); ++i)
    text += fmt::format("{}{} {:g}", i == 0 ? "" : ", ", states[i], scale[i]);
  if (scale.size() > few) text += ", ...";
  return {"scale", text +
                       ": the units of errors and, times the relative one, of absolute "
                       "tolerances; `scale:` in the file gives others"};
}

}  // namespace odeum::cases
