// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/fit_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace odeum::judge {
namespace {

constexpr std::size_t fewest = 6;  // three numbers are fitted
constexpr double largest_scatter = 0.05;
// Neighbouring residuals that are alike show a term that the fit has not; less than this of it
// moves p by less than a tenth.
constexpr double largest_trend = 0.005;

/// log h and log e of a window, each less its mean over it.
struct Logarithms {
  std::vector<double> h;  ///< the steps themselves
  std::vector<double> x, y;
};

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}
void centre(std::vector<double>& v) {
  const double mean = std::reduce(v.begin(), v.end()) / static_cast<double>(v.size());
  for (double& x : v) x -= mean;
}

/// A straight line through log e - log |1 + D h|.
struct Attempt {
  double squares = std::numeric_limits<double>::infinity();
  double d = 0, order = 0;
  double neighbours = 0;  ///< sum of the products of neighbouring residuals
};

Attempt attempt(const Logarithms& log, double d) {
  std::vector<double> y(log.h.size());
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = log.y[i] - std::log(std::abs(1 + d * log.h[i]));
  centre(y);
  Attempt result{.squares = 0, .d = d, .order = dot(log.x, y) / dot(log.x, log.x)};
  for (std::size_t i = 0; i < y.size(); ++i) y[i] -= result.order * log.x[i];
  result.squares = dot(y, y);
  result.neighbours = std::inner_product(y.begin() + 1, y.end(), y.begin(), 0.0);
  return result;
}

/// The best D, u = D max(h) between -0.97 (the error changes sign just beyond the coarsest step)
/// and 30 (only the second term is visible).
Attempt best_attempt(const Logarithms& log) {
  // Evenly in log(1 + u), which is how much the factor bends the curve.
  const double low = std::log(0.03), high = std::log(31.0);
  const double coarsest = *std::ranges::max_element(log.h);
  constexpr int pieces = 64;
  Attempt best;
  double best_s = 0;
  const auto look_at = [&](double s) {
    if (const Attempt here = attempt(log, std::expm1(s) / coarsest); here.squares < best.squares) {
      best = here;
      best_s = s;
    }
  };
  for (int i = 0; i <= pieces; ++i) look_at(low + (high - low) * i / pieces);
  // Halving: to a 1e-4 of log(1 + u) after ten.
  double step = (high - low) / pieces;
  for (int halving = 0; halving < 10; ++halving) {
    step /= 2;
    for (const double s : {best_s - step, best_s + step})
      if (s >= low && s <= high) look_at(s);
  }
  return best;
}

TwoTermFit fit_window(const ErrorPoint* points, std::size_t n) {
  Logarithms log;
  for (std::size_t i = 0; i < n; ++i) {
    log.h.push_back(points[i].step);
    log.x.push_back(std::log(points[i].step));
    log.y.push_back(std::log(points[i].error));
  }
  centre(log.x);
  const Attempt best = best_attempt(log);
  // The accuracy of p given D: from the part of log h that is orthogonal to the derivative by D, h
  // / (1 + D h).
  std::vector<double> z;
  for (const double h : log.h) z.push_back(h / (1 + best.d * h));
  centre(z);
  const double left = dot(log.x, log.x) - dot(log.x, z) * dot(log.x, z) / dot(z, z);
  const double spread = std::sqrt(best.squares / static_cast<double>(n - 3) / left);
  double log_factor = 0;
  for (std::size_t i = 0; i < n; ++i)
    log_factor += (std::log(points[i].error) - best.order * std::log(points[i].step) -
                   std::log(std::abs(1 + best.d * points[i].step))) /
                  static_cast<double>(n);
  return {.order = best.order,
          .log_factor = log_factor,
          .second = best.d,
          .half_width = student_t(n - 3) * spread,
          .scatter = std::sqrt(best.squares / static_cast<double>(n)),
          .second_at_finest = std::abs(best.d) * points[n - 1].step,
          .trend = std::sqrt(std::max(0.0, best.neighbours) / static_cast<double>(n)),
          .points = n};
}

}  // namespace

TwoTermFit fit_two_terms(const std::vector<ErrorPoint>& points) {
  TwoTermFit best;
  for (std::size_t dropped = 0; dropped <= 2; ++dropped)
    for (std::size_t n = fewest; n + dropped <= points.size(); ++n) {
      const std::size_t first = points.size() - dropped - n;
      TwoTermFit fit = fit_window(points.data() + first, n);
      fit.first = first;
      if (fit.scatter > largest_scatter) break;
      if (fit.trend > largest_trend || fit.second_at_finest > 1) continue;
      if (best.points == 0 || fit.half_width < best.half_width) best = fit;
    }
  return best;
}

}  // namespace odeum::judge
