// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "odeum/control/adaptive.hpp"
#include "odeum/core/outcome.hpp"
#include "odeum/kernel/method.hpp"

namespace odeum::methods {

/// Taylor's method: the series of the solution, from the recurrence that the problem offers. Order
/// 12 at a fixed step. Adaptive runs take the order of least work for the tolerance, and h = 1/e^2
/// of the radius of convergence estimated from the last two coefficients (Jorba and Zou).
struct taylor {
  static constexpr int fixed_order = 12;
  static constexpr MethodInfo info{
      .id = "taylor",
      .family = "taylor",
      .order = fixed_order,
      .adaptive_order = true,
      .controller = "order by the tolerance, step by the radius of convergence",
      .source =
          "Jorba, Zou, Experimental Mathematics 14 (2005) 99-117, sections 3.1, 3.2; Hairer, "
          "Norsett, Wanner, Solving ODEs I, I.8"};
  static constexpr auto inlined = Inlined::nonstiff;
  static constexpr std::string_view needs = "a problem that offers its Taylor series";
  template <class P>
  static constexpr bool fits = WithTaylorSeries<P>;
  template <class P>
  static bool fits_problem(const P& problem) {
    return offers_taylor(problem);
  }

  /// y <- sum_k c_k h^k by Horner's rule, with c laid out as in WithTaylorSeries.
  template <class S>
  static void sum(const std::vector<double>& c, int order, double h, S& y) {
    const std::size_t n = y.size();
    for (std::size_t i = 0; i < n; ++i) {
      double value = 0;
      for (std::size_t k = static_cast<std::size_t>(order) + 1; k-- > 0;)
        value = value * h + c[k * n + i];
      y[i] = value;
    }
  }

  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem)
        : problem_(problem), c_((fixed_order + 1) * size_of(problem)) {}

    Status step(double t, double h, State<P>& y) {
      problem_.taylor(t, y.data(), fixed_order, c_.data());
      sum(c_, fixed_order, h, y);
      return Status::ok;
    }

   private:
    const P& problem_;
    std::vector<double> c_;
  };

  /// The step size by the last two coefficients of the series, each component in units of its
  /// threshold (1 / weight); infinite for a polynomial.
  template <class S>
  static double safe_step(const std::vector<double>& c, int order, const S& weights) {
    const std::size_t n = weights.size();
    const auto size = [&](int k) {
      double largest = 0;
      for (std::size_t i = 0; i < n; ++i)
        largest = std::max(largest, std::abs(c[static_cast<std::size_t>(k) * n + i]) * weights[i]);
      return largest;
    };
    const double scale = std::max(1.0, size(0));
    double radius = std::numeric_limits<double>::infinity();
    for (const int k : {order - 1, order})
      if (size(k) > 0) radius = std::min(radius, std::pow(scale / size(k), 1.0 / k));
    return radius * std::exp(-2 - 0.7 / (order - 1));
  }

  /// Trial steps: the series at (t, y) determines the step in advance.
  template <class P>
  class Trial {
   public:
    Trial(const P& problem, const Tolerance& tolerance)
        : problem_(problem),
          order_(std::clamp(static_cast<int>(std::ceil(1 - std::log(tolerance.relative) / 2)), 3,
                            highest_taylor_order)),
          c_((static_cast<std::size_t>(order_) + 1) * size_of(problem)),
          weights_(make_state(problem)) {
      for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] = 1 / tolerance.threshold(i);
    }

    double longest_step(double t, const State<P>& y) {
      problem_.taylor(t, y.data(), order_, c_.data());
      double finite = 0;  // NaN where a coefficient is not finite
      for (const double x : c_) finite += x * 0;
      return safe_step(c_, order_, weights_) + finite;
    }
    Decision operator()(double, double h, const State<P>&, State<P>& y_new) const {
      sum(c_, order_, h, y_new);
      return {true, h};
    }
    Status between(const StepMade<State<P>>& step, double time, State<P>& y) const {
      sum(c_, order_, time - step.t, y);
      return Status::ok;
    }

   private:
    const P& problem_;
    int order_;
    std::vector<double> c_;
    State<P> weights_;
  };

  template <class P>
  static auto trial_steps(const P& problem, double, const State<P>&, double,
                          const Tolerance& tolerance) {
    return TrialSteps<Trial<P>>{0, {problem, tolerance}};
  }

  static double amplification(double re, double im) {
    std::complex<double> series = 1;
    for (int k = fixed_order; k > 0; --k)
      series = 1.0 + series * std::complex<double>(re, im) / static_cast<double>(k);
    return std::abs(series);
  }
};

}  // namespace odeum::methods
