// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <chrono>
#include <cstdint>
#include <string>

#include "odeum/core/outcome.hpp"
#include "odeum/problem/ode_view.hpp"

namespace odeum {

/// Checks every evaluation of a right-hand side: counts it, keeps the budget, and records the first
/// non-finite value with its time and component. Such a value does not end a run, since a solver
/// may reject the step that it came from; it explains a run that fails. One guard per solve.
class Guard {
 public:
  Guard(std::size_t dimension, const Budget& budget)
      : dimension_(dimension), budget_(budget), start_(Clock::now()) {}

  /// Whether evaluations are counted and checked: not in a timed run.
  bool watches() const { return budget_.watched; }

  /// To be called before an evaluation. False: the budget is spent, stop.
  bool admit() {
    if (tripped()) return false;
    // Reading the clock costs more than a small right-hand side, so it is read rarely.
    const bool look = spent() >= budget_.evaluations || (rhs_evaluations_ & 0x3ff) == 0x3ff;
    if (look && !may_go_on()) return false;
    ++rhs_evaluations_;
    return true;
  }

  /// To be called after an evaluation with its values, of n components from index `first` on (an
  /// acceleration is the second half). False: one is not finite.
  bool inspect(double t, const double* values, std::size_t n, std::size_t first = 0) {
    if (is_finite(values, n)) return true;
    if (first_non_finite_.empty()) describe(t, values, n, first);
    return false;
  }

  void count_jacobian() { ++jacobian_evaluations_; }
  /// A product of the Jacobian with a vector counts like an evaluation.
  void count_products(std::uint64_t count) { products_ += count; }

  bool tripped() const { return !exhausted_.empty(); }  ///< the budget is spent
  const std::string& first_non_finite() const { return first_non_finite_; }  ///< empty: none
  std::uint64_t rhs_evaluations() const { return rhs_evaluations_; }
  std::uint64_t jacobian_evaluations() const { return jacobian_evaluations_; }

  /// The verdict on a solve. A spent budget overrides the library's status; a success is accepted
  /// only if every stop was recorded, the end was reached and the states are finite.
  void conclude(const Request& request, Outcome& outcome) const;

 private:
  std::uint64_t spent() const { return rhs_evaluations_ + products_; }
  using Clock = std::chrono::steady_clock;
  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  bool may_go_on();
  bool exhaust(std::string why);
  void describe(double t, const double* values, std::size_t n, std::size_t first);
  void judge(const Request& request, Outcome& outcome) const;

  std::size_t dimension_;
  Budget budget_;
  Clock::time_point start_;
  std::uint64_t rhs_evaluations_ = 0;
  std::uint64_t jacobian_evaluations_ = 0;
  std::uint64_t products_ = 0;
  std::string exhausted_, first_non_finite_;
};

/// A guarded problem for C interfaces. The functions return 0, or 1 once the budget is spent.
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
    guard_.inspect(t, dydt, view_.dimension);
    return 0;
  }
  /// Dense, row-major.
  int jacobian(double t, const double* y, double* j) {
    if (guard_.tripped()) return 1;
    guard_.count_jacobian();
    view_.jacobian(view_.problem, t, y, j);
    return 0;
  }
  /// The values of view().sparsity; to be called where view().jacobian_entries is not null.
  int jacobian_entries(double t, const double* y, double* values) {
    if (guard_.tripped()) return 1;
    guard_.count_jacobian();
    view_.jacobian_entries(view_.problem, t, y, values);
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
    guard_.inspect(t, a, view_.degrees_of_freedom, view_.degrees_of_freedom);
    return 0;
  }

  const OdeView& view() const { return view_; }
  Guard& guard() { return guard_; }

 private:
  OdeView view_;
  Guard guard_;
};

}  // namespace odeum
