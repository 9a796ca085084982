// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/study/two_term_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/study/student.hpp"

namespace odeum::study {
namespace {

constexpr std::size_t fewest_points = 6;  // three numbers are fitted
constexpr double largest_scatter = 0.05;
// Neighbouring residuals that are alike show a term that the fit has not; less than this of it
// moves p by less than a tenth.
constexpr double largest_trend = 0.005;

using Design = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// log e against 1, log h and h / (1 + D h): the design of the last of these is the derivative by
/// D.
struct Attempt {
  double squares = std::numeric_limits<double>::infinity();
  double d = 0, order = 0;
  double neighbours = 0;  ///< sum of the products of neighbouring residuals
};

Attempt attempt(const Eigen::VectorXd& h, const Eigen::VectorXd& log_e, double d) {
  const Eigen::VectorXd x = h.array().log();
  const Eigen::VectorXd y = log_e.array() - (1 + d * h.array()).abs().log();
  const Eigen::VectorXd dx = x.array() - x.mean(), dy = y.array() - y.mean();
  Attempt result{.squares = 0, .d = d, .order = dx.dot(dy) / dx.squaredNorm()};
  const Eigen::VectorXd residual = dy - result.order * dx;
  const Eigen::Index n = residual.size();
  result.squares = residual.squaredNorm();
  result.neighbours = residual.head(n - 1).dot(residual.tail(n - 1));
  return result;
}

/// The best D, u = D max(h) between -0.97 (the error changes sign just beyond the coarsest step)
/// and 30 (the second term is all there is to see).
Attempt best_attempt(const Eigen::VectorXd& h, const Eigen::VectorXd& log_e) {
  // Evenly in log(1 + u), which is how much the factor bends the curve.
  const double low = std::log(0.03), high = std::log(31.0);
  const auto at = [&](double s) { return attempt(h, log_e, std::expm1(s) / h.maxCoeff()); };
  constexpr int pieces = 64;
  Attempt best;
  double best_s = 0;
  for (int i = 0; i <= pieces; ++i) {
    const double s = low + (high - low) * i / pieces;
    if (const Attempt here = at(s); here.squares < best.squares) {
      best = here;
      best_s = s;
    }
  }
  for (double step = (high - low) / pieces / 2; step > 1e-4; step /= 2)
    for (const double s : {best_s - step, best_s + step})
      if (const Attempt here = at(s); here.squares < best.squares && s >= low && s <= high) {
        best = here;
        best_s = s;
      }
  return best;
}

TwoTermFit fit_window(const ErrorPoint* points, std::size_t n) {
  const auto size = static_cast<Eigen::Index>(n);
  Eigen::VectorXd h(size), log_e(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    h[i] = points[i].step;
    log_e[i] = std::log(points[i].error);
  }
  const Attempt best = best_attempt(h, log_e);
  Design design(size, 3);
  design.col(0).setOnes();
  design.col(1) = h.array().log();
  design.col(2) = h.array() / (1 + best.d * h.array());
  const double variance = best.squares / static_cast<double>(n - 3);
  const Eigen::Matrix3d normal = design.transpose() * design;
  const double spread = std::sqrt(variance * normal.inverse()(1, 1));
  return {.order = best.order,
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
    for (std::size_t n = fewest_points; n + dropped <= points.size(); ++n) {
      const std::size_t first = points.size() - dropped - n;
      TwoTermFit fit = fit_window(points.data() + first, n);
      fit.first = first;
      if (fit.scatter > largest_scatter) break;
      if (fit.trend > largest_trend || fit.second_at_finest > 1) continue;
      if (best.points == 0 || fit.half_width < best.half_width) best = fit;
    }
  return best;
}

}  // namespace odeum::study
