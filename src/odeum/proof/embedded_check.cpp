// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/embedded_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "odeum/core/numbers.hpp"
#include "odeum/judge/order_fit.hpp"
#include "odeum/proof/test_problems.hpp"

namespace odeum::proof {
namespace {

TestProblem<FunctionProblem> quadrature() {
  TestProblem<FunctionProblem> g;
  g.id = "quadrature";
  g.problem.unknowns = 1;
  g.problem.f = [](double t, const double*, double* f) {
    f[0] = std::exp(std::sin(2 * t)) * std::cos(2 * t);
  };
  g.problem.f_y = [](double, const double*, double* j) { j[0] = 0; };
  g.problem.f_t = [](double t, const double*, double* d) {
    const double c = std::cos(2 * t), s = std::sin(2 * t);
    d[0] = 2 * std::exp(s) * (c * c - s);
  };
  g.truth = [](double t, double* y) { y[0] = std::exp(std::sin(2 * t)) / 2; };
  return g;
}

double norm(const std::vector<double>& x) {
  return std::sqrt(std::inner_product(x.begin(), x.end(), x.begin(), 0.0));
}

/// Sizes at one h, root mean square over several points of the solution, so that a zero of the
/// error at one of them has no effect.
struct Sizes {
  double h = 0, estimate = 0, lower_error = 0, kept_error = 0, scale = 0;
};

template <class P>
Sizes sizes_at(AnyStepper& stepper, const TestProblem<P>& test, double h, bool kept_is_lower) {
  constexpr int places = 8;
  Sizes sizes{.h = h};
  const std::size_t n = test.problem.size();
  for (int place = 0; place < places; ++place) {
    const double t = test.t0 + 0.23 * place;
    std::vector<double> y(n), exact(n), error(n), lower(n), kept(n);
    test.truth(t, y.data());
    test.truth(t + h, exact.data());
    stepper.start(t, h, y);
    if (stepper.step(t, h, y, &error) != Status::ok) return {h, nan, nan, nan, nan};
    for (std::size_t i = 0; i < n; ++i) {
      kept[i] = y[i] - exact[i];
      lower[i] = kept_is_lower ? kept[i] : kept[i] - error[i];
    }
    const auto add = [](double& sum, double x) { sum += x * x / places; };
    add(sizes.estimate, norm(error));
    add(sizes.lower_error, norm(lower));
    add(sizes.kept_error, norm(kept));
    sizes.scale = std::max(sizes.scale, norm(exact));
  }
  for (double* x : {&sizes.estimate, &sizes.lower_error, &sizes.kept_error}) *x = std::sqrt(*x);
  return sizes;
}

template <class P>
EstimateQuality judge(AnyStepper& stepper, const TestProblem<P>& test, int order,
                      int order_embedded) {
  EstimateQuality quality;
  quality.test_problem = test.id;
  quality.expected_exponent = std::min(order, order_embedded) + 1;
  quality.exponent = quality.ratio = quality.margin = nan;
  std::vector<judge::ErrorPoint> points;
  double nearest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 28; ++k) {
    const Sizes s = sizes_at(stepper, test, std::pow(2.0, -k / 3.0), order <= order_embedded);
    const double half_unit = s.scale * std::numeric_limits<double>::epsilon() / 2;
    // An estimate is a sum whose weights cancel; of verner98 their moduli sum to 6.
    points.push_back({.step = s.h,
                      .error = s.estimate,
                      .steps = 1,
                      .rounding_unit = 8 * half_unit,
                      .scale = s.scale});
    const bool seen = std::max(s.estimate, s.lower_error) > 100 * half_unit;
    const double larger = std::max(s.estimate, s.lower_error);
    if (const double distance = std::abs(std::log(larger / 1e-6)); seen && distance < nearest) {
      nearest = distance;
      quality.ratio = s.estimate / s.lower_error;
      quality.margin = s.estimate / s.kept_error;
    }
  }
  quality.exponent = judge::fit_order(points, quality.expected_exponent,
                                      judge::fixed_step_tolerance(quality.expected_exponent))
                         .order;
  return quality;
}

template <class P>
std::vector<EstimateQuality> judge_on(const std::vector<TestProblem<P>>& where,
                                      const MakeStepper<P>& make, int order, int order_embedded) {
  std::vector<EstimateQuality> all;
  for (const TestProblem<P>& test : where)
    all.push_back(judge(*make(test.problem), test, order, order_embedded));
  return all;
}

}  // namespace

bool EstimateQuality::good() const {
  return right_exponent() && ratio >= ratio_low && ratio <= ratio_high;
}
bool EstimateQuality::right_exponent() const {
  return std::abs(exponent - expected_exponent) <= 0.06 * expected_exponent;
}

std::vector<EstimateQuality> estimate_quality(const MakeStepper<FunctionProblem>& make, int order,
                                              int order_embedded) {
  std::vector<TestProblem<FunctionProblem>> where = test_problems();
  where.push_back(quadrature());
  return judge_on(where, make, order, order_embedded);
}

std::vector<EstimateQuality> estimate_quality(const MakeStepper<FunctionMechanics<false>>& make,
                                              int order, int order_embedded) {
  return judge_on(separable_test_problems(), make, order, order_embedded);
}

}  // namespace odeum::proof
