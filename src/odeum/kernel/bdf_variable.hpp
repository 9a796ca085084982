// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "odeum/control/adaptive.hpp"
#include "odeum/kernel/difference_history.hpp"
#include "odeum/kernel/quick_power.hpp"
#include "odeum/linear/shifted_solver.hpp"

namespace odeum {

/// Numerical differentiation formulas of orders 1 to 5 with a quasi-constant step (Shampine,
/// Reichelt, The MATLAB ODE suite, SIAM J. Sci. Comput. 18 (1997) 1-22, section 2): the method
/// stores backward differences of the solution and interpolates them to another grid when the step
/// changes. One run from t0 through every stop; stops before the last are interpolated.
template <Ode P>
class VariableBdf {
 public:
  VariableBdf(const Guarded<P>& problem, double t0, const State<P>& y0, const Request& request)
      : problem_(problem),
        request_(request),
        tolerance_(request.tolerance / 20),
        system_(problem),
        t_(t0),
        difference_(problem) {
    for (State<P>* state : {&y_, &psi_, &d_, &f_, &scale_}) *state = make_state(problem);
    h_ = initial_step(problem, t0, y0, request.stops.back(), 1, tolerance_);
    difference_[0] = y0;
    problem.rhs(t0, y0.data(), difference_[1].data());
    for (double& component : difference_[1]) component *= h_;
    newton_tolerance_ = std::max(10 * std::numeric_limits<double>::epsilon() / tolerance_,
                                 std::min(0.03, std::sqrt(tolerance_)));
  }

  Outcome run() {
    Outcome outcome;
    for (std::size_t s = 0; s < request_.stops.size(); ++s) {
      const bool last = s + 1 == request_.stops.size();
      const double stop = request_.stops[s];
      while (t_ < stop) {
        outcome.t = t_;
        const double smallest = std::max(16 * std::numeric_limits<double>::epsilon() * std::abs(t_),
                                         std::numeric_limits<double>::min());
        if (!(h_ >= smallest)) {
          outcome.status = Status::step_too_small;
          outcome.detail = fmt::format("step {} at t = {} is at the rounding of t", h_, t_);
          return outcome;
        }
        const double end = request_.stops.back();
        const double rounding = 16 * std::numeric_limits<double>::epsilon() * std::abs(end);
        const bool to_end = t_ + h_ >= end - rounding;
        if (to_end && t_ + h_ != end) rescale((end - t_) / h_);
        const bool accepted = try_step(to_end ? end : t_ + h_);
        if (problem_.tripped()) return outcome;
        ++(accepted ? outcome.counters.steps : outcome.counters.rejected_steps);
      }
      if (last)
        y_ = difference_[0];
      else
        difference_.interpolate(stop, t_, h_, static_cast<std::size_t>(order_), y_);
      outcome.record(stop, y_.data(), y_.size());
    }
    return outcome;
  }

 private:
  static constexpr int max_order = 5;
  static constexpr std::array<double, max_order + 1> kappa{0,       -0.1850, -1. / 9,
                                                           -0.0823, -0.0415, 0};
  /// gamma_k = 1 + 1/2 + ... + 1/k.
  static constexpr std::array<double, max_order + 1> gamma = [] {
    std::array<double, max_order + 1> g{};
    for (std::size_t k = 1; k <= max_order; ++k) g[k] = g[k - 1] + 1 / static_cast<double>(k);
    return g;
  }();
  static constexpr double error_constant(int k) {
    const auto i = static_cast<std::size_t>(k);
    return k == 0 ? 1 : kappa[i] * gamma[i] + 1 / static_cast<double>(k + 1);
  }

  bool try_step(double t_new) {
    const auto k = static_cast<std::size_t>(order_);
    const double alpha = (1 - kappa[k]) * gamma[k], c = h_ / alpha;
    for (std::size_t n = 0; n < y_.size(); ++n) {
      double predicted = difference_[0][n], psi = 0;
      for (std::size_t j = 1; j <= k; ++j) {
        predicted += difference_[j][n];
        psi += gamma[j] * difference_[j][n];
      }
      y_[n] = predicted;
      d_[n] = 0;
      psi_[n] = psi / alpha;
      scale_[n] = 1 / (tolerance_ * (1 + std::abs(predicted)));
    }
    int iterations = 0;
    if (!converge(t_new, c, iterations)) {
      rescale(0.3);
      return false;
    }
    const double safety = 0.9 * (2.0 * max_iterations + 1) / (2.0 * max_iterations + iterations);
    const double error = std::abs(error_constant(order_)) * norm(d_);
    if (!(error <= 1)) {
      rescale(std::isfinite(error) ? std::max(0.2, safety * quick_power(error, -1.0 / (order_ + 1)))
                                   : 0.2);
      return false;
    }
    t_ = t_new;
    jacobian_fresh_ = false;
    ++equal_steps_;
    difference_.advance(k, d_);
    if (equal_steps_ > order_) choose_order(error, safety);
    return true;
  }

  /// The order among k - 1, k, k + 1 that allows the longest step.
  void choose_order(double error, double safety) {
    const auto k = static_cast<std::size_t>(order_);
    const auto factor_of = [](double size, int order) {
      return quick_power(std::max(size, 1e-10), -1.0 / (order + 1));
    };
    double best = factor_of(error, order_);
    int order = order_;
    if (order_ > 1) {
      const double lower =
          factor_of(std::abs(error_constant(order_ - 1)) * norm(difference_[k]), order_ - 1);
      if (lower > best) best = lower, order = order_ - 1;
    }
    if (order_ < max_order) {
      const double higher =
          factor_of(std::abs(error_constant(order_ + 1)) * norm(difference_[k + 2]), order_ + 1);
      if (higher > best) best = higher, order = order_ + 1;
    }
    order_ = order;
    const double factor = std::min(10.0, safety * best);
    // A small change of the step is not made, so that the factors can be reused.
    if (factor < 1 || factor >= 1.2 || order != static_cast<int>(k)) rescale(factor);
  }

  /// Newton on d = y - predicted: d = c f(t, y) - psi, psi the weighted differences.
  bool converge(double t_new, double c, int& iterations) {
    while (true) {
      if (!linearised_ && !jacobian_fresh_) {
        system_.linearise(t_new, y_);
        linearised_ = jacobian_fresh_ = true;
        factored_for_ = 0;
      }
      if (c != factored_for_) {
        factored_for_ = 0;
        if (!system_.factorise(c)) return false;
        factored_for_ = c;
      }
      guess();
      double last = 0;
      for (iterations = 1; iterations <= max_iterations; ++iterations) {
        problem_.rhs(t_new, y_.data(), f_.data());
        for (std::size_t n = 0; n < y_.size(); ++n) f_[n] = c * f_[n] - psi_[n] - d_[n];
        if (!system_.solve(f_.data())) return false;
        for (std::size_t n = 0; n < y_.size(); ++n) {
          y_[n] += f_[n];
          d_[n] += f_[n];
        }
        const double size = norm(f_);
        if (!std::isfinite(size)) break;
        if (size == 0) return true;
        if (iterations > 1) {
          const double rate = size / last;
          if (rate >= 1 ||
              power(rate, max_iterations - iterations) / (1 - rate) * size > newton_tolerance_)
            if (rate >= 1 || iterations < max_iterations) break;
          if (rate / (1 - rate) * size <= newton_tolerance_) return true;
        }
        last = size;
      }
      if (jacobian_fresh_) return false;
      linearised_ = false;  // try again from the prediction with a new Jacobian
    }
  }

  /// The prediction y - d. Components whose sign differs from the state's start from the state
  /// instead: their Newton iteration could converge to another solution, or overshoot a decay to
  /// zero.
  void guess() {
    for (std::size_t n = 0; n < y_.size(); ++n) {
      const double predicted = y_[n] - d_[n], state = difference_[0][n];
      y_[n] = predicted * state < 0 ? state : predicted;
      d_[n] = y_[n] - predicted;
    }
  }

  double norm(const State<P>& x) const {
    double sum = 0;
    for (std::size_t n = 0; n < x.size(); ++n) sum += (x[n] * scale_[n]) * (x[n] * scale_[n]);
    return std::sqrt(sum / static_cast<double>(x.size()));
  }

  /// h <- factor h, the differences with it.
  void rescale(double factor) {
    difference_.rescale(factor, static_cast<std::size_t>(order_));
    h_ *= factor;
    equal_steps_ = 0;
  }

  static constexpr int max_iterations = 4;

  const Guarded<P>& problem_;
  const Request& request_;
  /// Local errors of many small steps of low order accumulate: the local tolerance is a fraction of
  /// the one requested, so that the error at the end meets it.
  double tolerance_;
  ShiftedSystem<Guarded<P>> system_;
  double t_, h_ = 0, newton_tolerance_ = 0, factored_for_ = 0;
  int order_ = 1, equal_steps_ = 0;
  bool linearised_ = false, jacobian_fresh_ = false;
  State<P> y_, psi_, d_, f_, scale_;
  DifferenceHistory<max_order, Guarded<P>> difference_;
};

}  // namespace odeum
