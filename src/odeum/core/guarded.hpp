// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/core/counted_solver.hpp"
#include "odeum/core/guard.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/problem/shared.hpp"

namespace odeum {

/// A problem with the capabilities of P, each evaluation checked by a guard. Once the guard has
/// tripped the right-hand side returns zero; steppers check `tripped()` after each step.
template <Ode P>
class Guarded {
 public:
  static constexpr std::size_t dimension = P::dimension;

  Guarded(const P& problem, Guard& guard) : problem_(problem), guard_(guard) {}

  std::size_t size() const { return size_of(problem_); }
  bool autonomous() const { return is_autonomous(problem_); }

  void rhs(double t, const double* y, double* dydt) const {
    if (!guard_.watches()) {
      problem_.rhs(t, y, dydt);
    } else if (guard_.admit()) {
      problem_.rhs(t, y, dydt);
      guard_.inspect(t, dydt, size());
    } else {
      for (std::size_t i = 0; i < size(); ++i) dydt[i] = 0;
    }
  }
  void jacobian(double t, const double* y, double* j) const requires WithJacobian<P> {
    guard_.count_jacobian();
    if constexpr (Shared<P>) {
      // Each evaluation of the differences is counted too.
      if (!problem_.offers_jacobian()) return difference_jacobian(*this, t, y, j);
    }
    problem_.jacobian(t, y, j);
  }
  const Sparsity* sparsity() const requires WithSparsity<P> { return problem_.sparsity(); }
  bool offers_entries() const requires WithJacobianEntries<P> {
    if constexpr (requires { problem_.offers_entries(); }) return problem_.offers_entries();
    return true;
  }
  void jacobian_entries(double t, const double* y,
                        double* values) const requires WithJacobianEntries<P> {
    guard_.count_jacobian();
    problem_.jacobian_entries(t, y, values);
  }
  void time_derivative(double t, const double* y, double* dfdt) const requires NonAutonomous<P> {
    problem_.time_derivative(t, y, dfdt);
  }
  static constexpr bool velocity_dependent = [] {
    if constexpr (SecondOrder<P>) return P::velocity_dependent;
    return true;
  }();
  void acceleration(double t, const double* q, const double* v,
                    double* a) const requires SecondOrder<P> {
    watched(t, a, [&] { problem_.acceleration(t, q, v, a); });
  }
  bool offers_damping() const requires WithDamping<P> {
    if constexpr (requires { problem_.offers_damping(); }) return problem_.offers_damping();
    return true;
  }
  void undamped_acceleration(double t, const double* q, double* a) const requires WithDamping<P> {
    watched(t, a, [&] { problem_.undamped_acceleration(t, q, a); });
  }
  std::uint64_t damp(double t, const double* q, double h, double* v,
                     double relative) const requires WithDamping<P> {
    const std::uint64_t products = problem_.damp(t, q, h, v, relative);
    guard_.count_products(products);
    return products;
  }
  /// Counts as `order` evaluations: one pass of the recurrence per coefficient.
  void taylor(double t, const double* y, int order, double* c) const requires WithTaylorSeries<P> {
    bool admitted = true;
    for (int k = 0; k < order; ++k) admitted = admitted && guard_.admit();
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) c[i] = y[i];
    for (std::size_t i = n; i < n * static_cast<std::size_t>(order + 1); ++i) c[i] = 0;
    if (!admitted) return;
    problem_.taylor(t, y, order, c);
    if (order > 0) guard_.inspect(t, c + n, n);
  }
  void linear_matrix(double* a) const requires LinearConstant<P> { problem_.linear_matrix(a); }
  std::unique_ptr<ShiftedSolver> shifted_solver() const requires WithShiftedSolver<P> {
    return counted(problem_.shifted_solver(), guard_);
  }

  bool tripped() const { return guard_.tripped(); }
  Guard& guard() const { return guard_; }

 private:
  template <class Evaluate>
  void watched(double t, double* a, Evaluate&& evaluate) const {
    if (!guard_.watches()) {
      evaluate();
    } else if (guard_.admit()) {
      evaluate();
      guard_.inspect(t, a, size() / 2, size() / 2);
    } else {
      for (std::size_t i = 0; i < size() / 2; ++i) a[i] = 0;
    }
  }

  const P& problem_;
  Guard& guard_;
};

/// A problem for timed runs with an inlined right-hand side: no guard.
template <Ode P>
struct Bare : P {};

template <Ode P>
class Guarded<Bare<P>> : public P {
 public:
  Guarded(const Bare<P>& problem, Guard& guard) : P(problem), guard_(guard) {}
  static constexpr bool tripped() { return false; }
  Guard& guard() const { return guard_; }

 private:
  Guard& guard_;
};

}  // namespace odeum
