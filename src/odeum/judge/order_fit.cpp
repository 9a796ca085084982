// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/order_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/judge/rounding_seen.hpp"
#include "odeum/judge/student.hpp"
#include "odeum/judge/two_term_fit.hpp"

namespace odeum::judge {
namespace {

constexpr std::size_t fewest_points = 4;
constexpr double shortest_span = 1.35;  // of the steps in a window
constexpr double finest_end = 1.65;     // of a window, against the finest step

/// A straight line through (log step, log error), by least squares.
struct Line {
  double slope = 0;
  double half_width = 0;  ///< of the slope's 95 % interval
};

Line fit_line(const ErrorPoint* points, std::size_t n) {
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < n; ++i) {
    mean_x += std::log(points[i].step) / static_cast<double>(n);
    mean_y += std::log(points[i].error) / static_cast<double>(n);
  }
  double xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double x = std::log(points[i].step) - mean_x, y = std::log(points[i].error) - mean_y;
    xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  Line line;
  line.slope = xy / xx;
  const double residual = std::max(0.0, yy - line.slope * xy);
  if (n > 2)
    line.half_width = student_t(n - 2) * std::sqrt(residual / static_cast<double>(n - 2) / xx);
  return line;
}

double local_slope(const ErrorPoint& coarse, const ErrorPoint& fine) {
  return std::log(coarse.error / fine.error) / std::log(coarse.step / fine.step);
}

/// The asymptotic window within usable points.
struct Window {
  std::size_t first = 0, count = 0;
};

// Local slopes are taken over steps this far apart, as a ladder's neighbours are. Between closer
// ones they would show the errors' noise.
constexpr double slope_span = 1.18;

/// The next finer point that a local slope is taken to; `end` where there is none.
std::size_t slope_partner(const std::vector<ErrorPoint>& points, std::size_t i, std::size_t end) {
  std::size_t j = i + 1;
  while (j < end && points[i].step < slope_span * points[j].step) ++j;
  return j;
}

// The finest four points or more whose local slopes agree, far enough apart, then coarser ones as
// long as their slopes agree with those four. High orders settle later, so their slopes may differ
// by more among the four. Errors that grow as the step shrinks are no convergence, however well
// their slopes agree.
Window find_window(const std::vector<ErrorPoint>& points, double claimed_order, double settled) {
  const double among_finest = settled * std::max(1.0, claimed_order / 2);
  for (std::size_t end = points.size(); end >= fewest_points; --end) {
    std::size_t first = end - fewest_points;
    while (first > 0 && points[first].step < shortest_span * points[end - 1].step) --first;
    if (points[first].step < shortest_span * points[end - 1].step) break;
    double sum = 0, low = 1e300, high = -1e300;
    int slopes = 0;
    for (std::size_t i = first; i < end; ++i) {
      const std::size_t j = slope_partner(points, i, end);
      if (j == end) break;
      const double slope = local_slope(points[i], points[j]);
      sum += slope;
      low = std::min(low, slope);
      high = std::max(high, slope);
      ++slopes;
    }
    const double mean = sum / slopes;
    if (low <= 0 || high - mean > among_finest || mean - low > among_finest) continue;
    while (first > 0) {
      const std::size_t partner = slope_partner(points, first - 1, end);
      if (partner == end ||
          std::abs(local_slope(points[first - 1], points[partner]) - mean) > settled)
        break;
      --first;
    }
    return {first, end - first};
  }
  return {};
}

// Two tolerances may lead to the same steps, and so to one measurement: the last one stays.
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

OrderFit conclude(OrderFit fit, Verdict verdict, std::string reason) {
  fit.verdict = verdict;
  fit.reason = std::move(reason);
  return fit;
}

}  // namespace

double ErrorPoint::typical_rounding() const {
  return rounding_unit * (8 + std::sqrt(steps)) + floor;
}

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return "confirmed";
    case Verdict::higher:
      return "higher";
    case Verdict::lower:
      return "lower";
    case Verdict::floors:
      return "floors";
    case Verdict::undetermined:
      return "undetermined";
    case Verdict::failed:
      return "failed";
    case Verdict::not_applicable:
      return "not_applicable";
  }
  return "undetermined";
}

OrderFit fit_order(const std::vector<ErrorPoint>& points, double claimed_order,
                   const FitTolerance& tolerance) {
  OrderFit fit;
  std::vector<ErrorPoint> solved;
  for (const ErrorPoint& point : points)
    if (std::isfinite(point.error)) solved.push_back(point);
  if (solved.empty()) return conclude(fit, Verdict::failed, "no step size could be solved");

  // A method that is exact on the case shows rounding only, which may grow with every step, and
  // for recurrences of second differences with its square; extrapolation weighs it by some tens.
  const auto rounding_only = [](const ErrorPoint& p) {
    return p.error <= 16 * p.rounding_unit * (8 + p.steps) * std::max(1.0, p.steps);
  };
  const auto largest_error = [](auto from, auto to) {
    double largest = 0;
    for (; from != to; ++from) largest = std::max(largest, from->error);
    return largest;
  };
  const auto middle = solved.begin() + static_cast<std::ptrdiff_t>(solved.size() / 2);
  const bool falls =
      largest_error(middle, solved.end()) < largest_error(solved.begin(), middle) / 10;
  if (solved.size() >= fewest_points && !falls &&
      std::all_of(solved.begin(), solved.end(), rounding_only)) {
    const double largest = largest_error(solved.begin(), solved.end());
    return conclude(fit, Verdict::higher,
                    fmt::format("exact but for rounding: errors up to {:.1e}", largest));
  }
  merge_same_steps(solved);

  // An error ten times the solution itself is a blow-up, and says nothing of an order.
  const auto blown_up = [](const ErrorPoint& p) {
    return p.error > 10 * p.rounding_unit / (std::numeric_limits<double>::epsilon() / 2);
  };
  if (!points.empty() && points.front().rounding_unit > 0) std::erase_if(solved, blown_up);

  // The fine end: points that rounding may have a part in, then points that no longer fall. An
  // error that stops falling well above rounding is a finding, not an end of the window.
  std::vector<ErrorPoint> usable = solved;
  const SeenRounding rounding(solved, std::isnan(claimed_order) ? 1 : claimed_order);
  while (!usable.empty() && usable.back().error <= rounding.limit(usable.back())) usable.pop_back();
  const auto stagnates = [&] {
    const std::size_t n = usable.size();
    return n >= 2 &&
           local_slope(usable[n - 2], usable[n - 1]) < 0.25 * std::min(1.0, claimed_order);
  };
  std::size_t stagnant = 0;
  for (; stagnates(); ++stagnant) {
    fit.floor =
        std::isnan(fit.floor) ? usable.back().error : std::min(fit.floor, usable.back().error);
    usable.pop_back();
  }

  const Window window =
      find_window(usable, std::isnan(claimed_order) ? 1 : claimed_order, tolerance.settled);
  if (window.count) {
    const ErrorPoint* const first = usable.data() + window.first;
    const Line line = fit_line(first, window.count);
    fit.order = line.slope;
    fit.low = line.slope - line.half_width;
    fit.high = line.slope + line.half_width;
    fit.points = window.count;
    fit.step_coarsest = first[0].step;
    fit.step_finest = first[window.count - 1].step;
  }

  if (std::isnan(claimed_order))
    return conclude(fit, Verdict::not_applicable,
                    "the order varies during a run, so none is claimed");
  // Two stagnant steps may be noise near rounding; three are a floor.
  if (stagnant >= 3)
    return conclude(fit, Verdict::floors,
                    fmt::format("stops converging at an error of {:.1e}", fit.floor));
  const bool settled = window.count > 0;
  // Slopes that scatter widely deny a claim as little as they confirm it.
  const bool wide = fit.high - fit.low > claimed_order / 2;
  if (settled && !wide && std::abs(fit.order - claimed_order) <= tolerance.order)
    return conclude(fit, Verdict::confirmed, "");
  // Slopes that still move, or settle elsewhere than they will: the next term of the error.
  const TwoTermFit two = fit_two_terms(usable);
  if (two.points > 0 && two.half_width <= tolerance.order &&
      std::abs(two.order - claimed_order) <= tolerance.order) {
    std::string reason = fmt::format(
        "local slopes still move, {:.2f} at the finest steps; by the error's first two terms, C "
        "h^p "
        "(1 + D h), p is {:.2f}",
        local_slope(usable[usable.size() - 2], usable.back()), two.order);
    fit.order = two.order;
    fit.low = two.order - two.half_width;
    fit.high = two.order + two.half_width;
    fit.points = two.points;
    fit.step_coarsest = usable[two.first].step;
    fit.step_finest = usable[two.first + two.points - 1].step;
    return conclude(fit, Verdict::confirmed, std::move(reason));
  }
  // Slopes that agree at coarse steps, where finer ones are clear of rounding and do not bear them
  // out, are a stretch before convergence.
  const bool borne_out = settled && fit.step_finest <= finest_end * usable.back().step;
  if (!borne_out) {
    if (usable.size() < fewest_points)
      return conclude(
          fit, Verdict::undetermined,
          fmt::format("{} of {} steps give an error that is solved, converging and clear of "
                      "rounding; {} are needed",
                      usable.size(), points.size(), fewest_points));
    return conclude(fit, Verdict::undetermined,
                    fmt::format("local slopes do not settle: {:.2f} at the finest steps",
                                local_slope(usable[usable.size() - 2], usable.back())));
  }
  if (wide || (fit.low <= claimed_order && claimed_order <= fit.high))
    return conclude(fit, Verdict::undetermined,
                    fmt::format("the slope {:.2f} is known to lie in [{:.2f}, {:.2f}] only, which "
                                "does not settle whether it is {:g}",
                                fit.order, fit.low, fit.high, claimed_order));
  return conclude(
      fit, fit.order > claimed_order ? Verdict::higher : Verdict::lower,
      fmt::format("converges with order {:.2f} where {:g} is claimed", fit.order, claimed_order));
}

}  // namespace odeum::judge
