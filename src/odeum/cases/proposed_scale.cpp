// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/proposed_scale.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace odeum::cases {
namespace {

/// The size to one digit, as it is written.
double rounded(double size) { return std::stod(fmt::format("{:.0e}", size)); }

bool is_near_one(double size) { return size >= 0.01 && size <= 100; }

/// Thousands of components have a long list.
std::string listed(std::vector<std::string> parts) {
  constexpr std::size_t few = 8;
  const std::string more =
      parts.size() > few ? fmt::format(", and {} more", parts.size() - few) : "";
  parts.resize(std::min(few, parts.size()));
  return fmt::format("{}{}", fmt::join(parts, ", "), more);
}

}  // namespace

ErrorUnits proposed_units(const truth::Along& along) {
  const double of_all = *std::ranges::max_element(along.largest);
  if (!(of_all > 0) || !std::isfinite(of_all)) return {};
  ErrorUnits units;
  for (const double size : along.largest) units.scale.push_back(rounded(size > 0 ? size : of_all));
  const bool falls = std::ranges::any_of(along.dips, [](double dip) { return dip > 0; });
  if (falls) {
    units.relative_from = along.dips;
    for (double& dip : units.relative_from)
      if (dip > 0) dip = rounded(dip);
  }
  if (!falls && std::ranges::all_of(along.largest,
                                    [](double size) { return size == 0 || is_near_one(size); }))
    units.scale.clear();
  return units;
}

void take_units(Case& c, const ErrorUnits& units, bool of_tolerances) {
  if (units.scale.empty()) return;
  std::vector<double> thresholds = units.scale;
  for (std::size_t i = 0; i < thresholds.size(); ++i)
    if (units.is_relative(i)) thresholds[i] = units.relative_from[i];
  if (of_tolerances)
    c.tolerance = Tolerance::of_thresholds(c.tolerance.relative, std::move(thresholds));
  c.units = units;
}

std::pair<std::string, std::string> units_fact(const ErrorUnits& units,
                                               const std::vector<std::string>& states,
                                               bool of_tolerances) {
  std::vector<std::string> scales, falling;
  for (std::size_t i = 0; i < units.scale.size(); ++i)
    if (units.is_relative(i))
      falling.push_back(fmt::format("{} (from {:g})", states[i], units.relative_from[i]));
    else
      scales.push_back(fmt::format("{} {:g}", states[i], units.scale[i]));
  std::string text = listed(scales);
  if (!scales.empty())
    text +=
        fmt::format(": the units of errors{}, by the largest value along the solution",
                    of_tolerances ? " and, times the relative one, of absolute tolerances" : "");
  if (!falling.empty())
    text += fmt::format(
        "{}{} rise{} tenfold from less than a thousandth of the largest value: there errors are "
        "relative to the exact value{}",
        scales.empty() ? "" : "; ", listed(falling), falling.size() == 1 ? "s" : "",
        of_tolerances ? ", and tolerances to the value" : "");
  return {"scale", text + "; `scale:` in the file gives others"};
}

}  // namespace odeum::cases
