// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/fit_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace odeum::judge {
namespace {

constexpr double float_rounding = 0x1p-24, double_rounding = 0x1p-53;
constexpr double unresolved = 0.1;  // of the solution: such errors vary and are not used

std::string scale_of(const std::vector<ErrorPoint>& points, const ErrorFloor& floor,
                     std::size_t end) {
  const ErrorPoint& at = points[(floor.first + end) / 2];
  if (at.rounding_unit == 0) return "";
  // Over the finer half, without the points that still fall.
  const std::size_t half = std::min((floor.first + end) / 2, end - 3);
  const PowerLaw law = fit_power_law(points.data() + half, end - half);
  const double growth = -law.order;  // with the number of steps
  const double size = floor.level / at.scale;
  // Rounding of unit u in each step comes to typical_rounding() at u = 2^-53.
  const double noise = double_rounding * floor.level / at.typical_rounding();
  if (law.half_width > 1 || growth > 1.6 || growth < -0.25)
    return fmt::format("erratic, about {:.0e} of the solution", size);
  if (noise > float_rounding / 16 && noise < float_rounding * 8)
    return "about what single precision leaves, 6e-08 in each step";
  if (growth > 0.75)
    return fmt::format(
        "proportional to the number of steps, {:.0e} of the solution in each: a tolerance of the "
        "solver's own",
        size / at.steps);
  if (growth > 0.25)
    return fmt::format(
        "proportional to the root of the number of steps: random errors of {:.0e} in each", noise);
  return fmt::format(
      "{:.0e} of the solution at all steps: coefficients or a tolerance of so many digits", size);
}

}  // namespace

ErrorFloor find_floor(const std::vector<ErrorPoint>& points, std::size_t end, double claimed_order,
                      double stray) {
  constexpr std::size_t fewest = 3;
  ErrorFloor floor{.first = end, .level = 0, .step = 0, .scale = ""};
  for (std::size_t n = fewest; n <= end; ++n) {
    const ErrorPoint* const first = points.data() + (end - n);
    if (fit_power_law(first, n).order >= 0.25 * std::min(1.0, claimed_order)) break;
    floor.first = end - n;
  }
  if (floor.first == end) return floor;
  floor.step = points[floor.first].step;
  std::vector<double> errors;
  for (std::size_t i = floor.first; i < end; ++i) errors.push_back(points[i].error);
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  floor.level = *middle;
  const double scale = points[floor.first].scale;
  const bool rounding = floor.level <= points[(floor.first + end) / 2].certain_error();
  const PowerLaw law = fit_power_law(points.data() + floor.first, end - floor.first);
  const double should_fall = std::pow(floor.step / points[end - 1].step, claimed_order);
  const bool settled = end - floor.first > fewest && law.half_width < 0.25;
  // Three points after an error that passed through zero by chance, of which the last two fall.
  const bool falls =
      end - floor.first == fewest && local_slope(points[end - 2], points[end - 1]) > 0.5;
  const bool large = scale > 0 && floor.level > unresolved * scale;
  if (rounding || falls || (!settled && (large || should_fall < stray * stray)))
    floor.first = end;
  else
    floor.scale = scale_of(points, floor, end);
  return floor;
}

}  // namespace odeum::judge
