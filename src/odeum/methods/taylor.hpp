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
/// of the radius of convergence estimated from the last two coefficients (Jorba and Zou). Where the
/// solution has no series, as that of y' = 1 + y^2.5 at y = 0, a step is one of Heun's method.
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

  static bool has_series(const std::vector<double>& c) {
    double finite = 0;
    for (const double x : c) finite += x * 0;
    return finite == 0;
  }

  /// Steps where there is no series.
  template <class P>
  class Heun {
   public:
    explicit Heun(const P& problem)
        : problem_(problem), slope_(make_state(problem)), end_slope_(slope_), end_(slope_) {}

    /// Begins at (t, y); false where f is not finite.
    bool begin(double t, const State<P>& y) { return is_finite(t, y, slope_); }
    bool is_inside(double t, const State<P>& y) { return is_finite(t, y, end_); }
    /// The state at t + h in `result`.
    void step(double t, double h, const State<P>& y, State<P>& result) {
      for (std::size_t i = 0; i < y.size(); ++i) end_[i] = y[i] + h * slope_[i];
      problem_.rhs(t + h, end_.data(), end_slope_.data());
      for (std::size_t i = 0; i < y.size(); ++i)
        result[i] = y[i] + h / 2 * (slope_[i] + end_slope_[i]);
    }
    /// The length of the step from (t, y) whose error is at the tolerance, estimated as that of
    /// Euler's method; NaN where f is not finite.
    double longest_step(double t, const State<P>& y, const State<P>& weights, double tolerance) {
      if (!begin(t, y)) return std::numeric_limits<double>::quiet_NaN();
      double size = 1, speed = 0;
      for (std::size_t i = 0; i < y.size(); ++i) {
        size = std::max(size, std::abs(y[i]) * weights[i]);
        speed = std::max(speed, std::abs(slope_[i]) * weights[i]);
      }
      constexpr double shortest = std::numeric_limits<double>::min();
      double h = speed > 0 ? size / speed : 1;
      for (; h > shortest; h /= 4) {
        step(t, h, y, end_);
        double error = 0;
        for (std::size_t i = 0; i < y.size(); ++i) {
          const double change = h / 2 * std::abs(end_slope_[i] - slope_[i]) * weights[i];
          error = change <= error ? error : change;  // NaN stays
        }
        if (error <= tolerance * size) break;
      }
      return h;
    }
    /// Inside the step made last.
    void between(const StepMade<State<P>>& made, double time, State<P>& y) const {
      const double d = time - made.t;
      for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = made.before[i] + d * (slope_[i] + d / (2 * made.h) * (end_slope_[i] - slope_[i]));
    }

   private:
    bool is_finite(double t, const State<P>& y, State<P>& f) {
      problem_.rhs(t, y.data(), f.data());
      return std::all_of(f.begin(), f.end(), [](double each) { return std::isfinite(each); });
    }
    const P& problem_;
    State<P> slope_, end_slope_, end_;
  };

  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem)
        : problem_(problem), heun_(problem), c_((fixed_order + 1) * size_of(problem)) {}

    Status step(double t, double h, State<P>& y) {
      problem_.taylor(t, y.data(), fixed_order, c_.data());
      if (has_series(c_)) {
        sum(c_, fixed_order, h, y);
      } else {
        heun_.begin(t, y);
        heun_.step(t, h, y, y);
      }
      return Status::ok;
    }

   private:
    const P& problem_;
    Heun<P> heun_;
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
          tolerance_(tolerance.relative),
          heun_(problem),
          weights_(make_state(problem)) {
      for (std::size_t i = 0; i < weights_.size(); ++i) weights_[i] = 1 / tolerance.threshold(i);
    }

    double longest_step(double t, const State<P>& y) {
      problem_.taylor(t, y.data(), order_, c_.data());
      by_series_ = has_series(c_);
      return part_ * (by_series_ ? safe_step(c_, order_, weights_)
                                 : heun_.longest_step(t, y, weights_, tolerance_));
    }
    Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
      by_series_ ? sum(c_, order_, h, y_new) : heun_.step(t, h, y, y_new);
      const bool inside = !changes_sign(y, y_new) || heun_.is_inside(t + h, y_new);
      part_ = inside ? 1 : part_ / 4;
      return {inside, h};
    }
    Status between(const StepMade<State<P>>& step, double time, State<P>& y) const {
      by_series_ ? sum(c_, order_, time - step.t, y) : heun_.between(step, time, y);
      return Status::ok;
    }

   private:
    /// Equations may end at 0 (sqrt), which a state of less than the tolerance can pass.
    static bool changes_sign(const State<P>& y, const State<P>& y_new) {
      for (std::size_t i = 0; i < y.size(); ++i)
        if (y_new[i] * y[i] < 0 || (y[i] == 0 && y_new[i] < 0)) return true;
      return false;
    }

    const P& problem_;
    int order_;
    std::vector<double> c_;
    bool by_series_ = true;  ///< the step to come, and the one made last
    double part_ = 1;  ///< of the longest step, after steps beyond the domain of the equations
    double tolerance_;
    Heun<P> heun_;
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
