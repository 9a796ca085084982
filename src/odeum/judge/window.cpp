// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/fit_parts.hpp"

#include <algorithm>

namespace odeum::judge {
namespace {

constexpr double shortest_span = 1.35;  // of the steps in a window

// Local slopes are taken over steps this far apart, as a ladder's neighbours are. Between closer
// ones the noise of the errors dominates.
constexpr double slope_span = 1.18;

/// The next finer point that a local slope is taken to; `end` where there is none.
std::size_t slope_partner(const std::vector<ErrorPoint>& points, std::size_t i, std::size_t end) {
  std::size_t j = i + 1;
  while (j < end && points[i].step < slope_span * points[j].step) ++j;
  return j;
}

/// The next coarser point that a local slope to point `fine` is taken from; 0: none is that far.
std::size_t coarser_partner(const std::vector<ErrorPoint>& points, std::size_t fine) {
  std::size_t i = fine;
  while (i > 0 && points[i].step < slope_span * points[fine].step) --i;
  return i;
}

/// Mean, least and largest local slope of points [first, end).
struct Slopes {
  double mean = 0, low = 0, high = 0;
};
Slopes slopes_of(const std::vector<ErrorPoint>& points, std::size_t first, std::size_t end) {
  Slopes slopes{.mean = 0, .low = 1e300, .high = -1e300};
  int count = 0;
  for (std::size_t i = first; i < end; ++i) {
    const std::size_t j = slope_partner(points, i, end);
    if (j == end) break;
    const double slope = local_slope(points[i], points[j]);
    slopes.mean += slope;
    slopes.low = std::min(slopes.low, slope);
    slopes.high = std::max(slopes.high, slope);
    ++count;
  }
  slopes.mean /= count;
  return slopes;
}

/// Whether the finest three local slopes of points [0, end) fall away, see falls_away().
bool fall_to(const std::vector<ErrorPoint>& points, std::size_t end, double order,
             const FitTolerance& tolerance) {
  std::vector<double> slopes;  // from the finest
  while (end > 0 && slopes.size() < 3) {
    const std::size_t i = coarser_partner(points, end - 1);
    if (points[i].step < slope_span * points[end - 1].step) return false;
    slopes.push_back(local_slope(points[i], points[end - 1]));
    end = i + 1;
  }
  const double near = tolerance.order;
  return slopes.size() == 3 && slopes[0] < slopes[1] && slopes[1] < slopes[2] &&
         slopes[2] - slopes[0] > near && order - slopes[0] > near &&
         slopes[2] < order + tolerance.apart;
}

}  // namespace

double ErrorPoint::typical_rounding() const { return rounding_unit * (8 + std::sqrt(steps)); }
double ErrorPoint::clear_error() const {
  return std::max(4.0, 10 / std::sqrt(components)) * (typical_rounding() + floor);
}
double ErrorPoint::certain_error() const { return 100 * typical_rounding() + 10 * floor; }

void merge_same_steps(std::vector<ErrorPoint>& points) {
  constexpr double same = 0.97;  // neighbours on a ladder of steps differ by 20 % at least
  std::vector<ErrorPoint> merged;
  for (const ErrorPoint& point : points) {
    if (!merged.empty() && point.step > same * merged.back().step)
      merged.back() = point;
    else
      merged.push_back(point);
  }
  points = std::move(merged);
}

bool is_exact(const std::vector<ErrorPoint>& points) {
  if (points.size() < fewest_points) return false;
  const double coarsest = points.front().steps;
  return std::ranges::all_of(points, [&](const ErrorPoint& p) {
    const double growth = std::max(1.0, p.steps / coarsest);
    return p.error <= 100 * p.typical_rounding() * growth * std::sqrt(growth);
  });
}

double rejected_share(const std::vector<ErrorPoint>& points) {
  if (points.size() < 2) return 0;
  const auto share = [](const ErrorPoint& p) { return p.rejected / (p.rejected + p.steps); };
  return std::min(share(points.back()), share(points[points.size() - 2]));
}

double slope_of_resolved(const std::vector<ErrorPoint>& points, std::size_t end) {
  const ErrorPoint& last = points[end - 1];
  for (const ErrorPoint& point : points)
    if (point.step > 2 * last.step && !(point.error > 0.1 * point.scale && point.scale > 0))
      return local_slope(point, last);
  return nan;
}

PowerLaw fit_power_law(const ErrorPoint* points, std::size_t n) {
  const auto count = static_cast<double>(n);
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    mean_x += std::log(points[i].step) / count;
    mean_y += std::log(points[i].error) / count;
  }
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = std::log(points[i].step) - mean_x, y = std::log(points[i].error) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  PowerLaw law{.order = xy / xx, .log_factor = mean_y - xy / xx * mean_x};
  const double residual = std::max(0.0, yy - law.order * xy);
  if (n > 2) law.half_width = student_t(n - 2) * std::sqrt(residual / (count - 2) / xx);
  return law;
}

double local_slope(const ErrorPoint& coarse, const ErrorPoint& fine) {
  return std::log(coarse.error / fine.error) / std::log(coarse.step / fine.step);
}

double local_slope_to(const std::vector<ErrorPoint>& points, std::size_t fine) {
  return local_slope(points[coarser_partner(points, fine)], points[fine]);
}

bool moves_towards(const std::vector<ErrorPoint>& points, const Window& window, double order,
                   double near) {
  constexpr std::size_t fewest_slopes = 3;
  const double how_much_finer = std::log(10);
  std::vector<double> x, distance;
  for (std::size_t i = window.first - std::min<std::size_t>(window.first, 1); i < window.end();
       ++i) {
    const std::size_t j = slope_partner(points, i, window.end());
    if (j == window.end()) break;
    const double next = local_slope(points[i], points[j]) - order;
    if (!distance.empty() &&
        (next * distance.back() <= 0 || std::abs(next) >= std::abs(distance.back()))) {
      if (i > window.first + 1) return false;
      x.clear(), distance.clear();  // higher terms of the error at coarse steps
    }
    x.push_back(std::log(points[i].step * points[j].step) / 2);
    distance.push_back(next);
  }
  if (distance.size() < fewest_slopes) return false;
  const std::size_t k = distance.size() - 1;
  const double last = std::abs(distance[k]);
  const double rate = (std::abs(distance[k - 1]) - last) / (x[k - 1] - x[k]);
  return last - rate * how_much_finer <= near;
}

bool falls_away(const std::vector<ErrorPoint>& points, std::size_t end, double order,
                const FitTolerance& tolerance) {
  if (std::isinf(tolerance.whole) || !fall_to(points, end, order, tolerance)) return false;
  // A thirtieth of the error changes a slope between neighbours by more than a tolerance.
  constexpr double visible = 30;
  while (end > 0 && points[end - 1].error <= visible * points[end - 1].certain_error()) --end;
  return fall_to(points, end, order, tolerance);
}

Window find_window(const std::vector<ErrorPoint>& points, std::size_t end, double claimed_order,
                   double settled) {
  const double among_finest = settled * std::max(1.0, claimed_order / 2);
  for (; end >= fewest_points; --end) {
    std::size_t first = end - fewest_points;
    while (first > 0 && points[first].step < shortest_span * points[end - 1].step) --first;
    if (points[first].step < shortest_span * points[end - 1].step) break;
    const Slopes slopes = slopes_of(points, first, end);
    if (slopes.low <= 0 || slopes.high - slopes.mean > among_finest ||
        slopes.mean - slopes.low > among_finest)
      continue;
    for (; first > 0; --first) {
      const std::size_t partner = slope_partner(points, first - 1, end);
      if (partner == end ||
          std::abs(local_slope(points[first - 1], points[partner]) - slopes.mean) > settled)
        break;
    }
    return {first, end - first};
  }
  return {};
}

}  // namespace odeum::judge
