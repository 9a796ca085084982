// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <chrono>
#include <cstdint>
#include <string>

#include "odeum/core/outcome.hpp"
#include "odeum/problem/ode_view.hpp"

namespace odeum {

/// Watches every evaluation of a right-hand side: counts it, keeps the budget, and latches the
/// first non-finite value with its time and component. One guard serves one solve.
class Guard {
 public:
  Guard(std::size_t dimension, const Budget& budget)
      : dimension_(dimension), budget_(budget), start_(Clock::now()) {}

  /// Whether to watch at all: not in a timed run.
  bool watches() const { return budget_.watched; }

  /// To be called before an evaluation. False: stop, `tripped()` says why.
  bool admit() {
    if (tripped_) return false;
    // Looking at the clock costs more than a small right-hand side: do it rarely.
    const bool look = spent() >= budget_.evaluations || (rhs_evaluations_ & 0x3ff) == 0x3ff;
    if (look && !may_go_on()) return false;
    ++rhs_evaluations_;
    return true;
  }

  /// To be called after an evaluation. False: a component is not finite.
  bool inspect(double t, const double* dydt) { return inspect(t, dydt, dimension_); }
  /// The same for n components from number `first` on: an acceleration is the second half.
  bool inspect(double t, const double* values, std::size_t n, std::size_t first = 0) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) sum += values[i] * 0.0;  // NaN when any is not finite
    return sum == 0.0 || latch(t, values, n, first);
  }

  void count_jacobian() { ++jacobian_evaluations_; }
  /// A product of the Jacobian with a vector is paid like an evaluation.
  void count_products(std::uint64_t count) { products_ += count; }

  bool tripped() const { return tripped_; }
  Status status() const { return status_; }
  const std::string& detail() const { return detail_; }
  std::uint64_t rhs_evaluations() const { return rhs_evaluations_; }
  std::uint64_t jacobian_evaluations() const { return jacobian_evaluations_; }

  /// The last word on a solve. What the guard saw outranks what the library says; a success is
  /// believed only if every stop was recorded, the end was reached and the states are finite.
  void conclude(const Request& request, Outcome& outcome) const;

 private:
  std::uint64_t spent() const { return rhs_evaluations_ + products_; }
  using Clock = std::chrono::steady_clock;
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  bool may_go_on();
  bool exhaust(std::string why);
  bool latch(double t, const double* values, std::size_t n, std::size_t first);

  std::size_t dimension_;
  Budget budget_;
  Clock::time_point start_;
  std::uint64_t rhs_evaluations_ = 0;
  std::uint64_t jacobian_evaluations_ = 0;
  std::uint64_t products_ = 0;
  bool tripped_ = false;
  Status status_ = Status::ok;
  std::string detail_;
};

/// A guarded problem for C interfaces. The functions return 0, or 1 when the guard tripped.
class GuardedView {
 public:
  GuardedView(const OdeView& view, const Budget& budget)
      : view_(view), guard_(view.dimension, budget) {}

  int rhs(double t, const double* y, double* dydt) {
    if (!guard_.watches()) {
      view_.rhs(view_.problem, t, y, dydt);
      return 0;
    }
    if (!guard_.admit()) return 1;
    view_.rhs(view_.problem, t, y, dydt);
    return guard_.inspect(t, dydt) ? 0 : 1;
  }
  /// Dense, row-major.
  int jacobian(double t, const double* y, double* j) {
    if (guard_.tripped()) return 1;
    guard_.count_jacobian();
    view_.jacobian(view_.problem, t, y, j);
    return 0;
  }
  /// df/dt; zeros for an autonomous problem.
  void time_derivative(double t, const double* y, double* dfdt) const {
    if (view_.time_derivative)
      view_.time_derivative(view_.problem, t, y, dfdt);
    else
      for (std::size_t i = 0; i < view_.dimension; ++i) dfdt[i] = 0;
  }
  int jacobian_times(double t, const double* y, const double* x, double* product) {
    guard_.count_products(1);
    view_.jacobian_times(view_.problem, t, y, x, product);
    return guard_.tripped() ? 1 : 0;
  }
  /// q'' = a; dimension of q, v and a is view().degrees_of_freedom. Counts as one evaluation.
  int acceleration(double t, const double* q, const double* v, double* a) {
    if (!guard_.admit()) return 1;
    view_.acceleration(view_.problem, t, q, v, a);
    return guard_.inspect(t, a, view_.degrees_of_freedom, view_.degrees_of_freedom) ? 0 : 1;
  }

  const OdeView& view() const { return view_; }
  Guard& guard() { return guard_; }

 private:
  OdeView view_;
  Guard guard_;
};

}  // namespace odeum
