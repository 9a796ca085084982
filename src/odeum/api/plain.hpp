// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>

#include "odeum/core/guarded.hpp"
#include "odeum/core/tolerance.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/problem/difference_jacobian.hpp"

namespace odeum {

/// Names a problem for runs without a guard: no budget, no search for values that are not finite.
template <Ode P>
struct Plain {
  static constexpr std::size_t dimension = P::dimension;
  using real = RealOf<P>;
  void rhs(real t, const real* y, real* dydt) const;  // never called: Guarded<Plain<P>> is
};

/// What a method sees of the problem of a plain run, which has to outlive it: the same, counted,
/// and by differences what implicit methods need and the problem lacks, without an allocation.
template <Ode P>
class Guarded<Plain<P>> {
 public:
  static constexpr std::size_t dimension = P::dimension;
  using real = RealOf<P>;
  static constexpr bool in_double = std::same_as<real, double>;
  static constexpr bool velocity_dependent = [] {
    if constexpr (SecondOrder<P>) return bool(P::velocity_dependent);
    return true;
  }();

  explicit Guarded(const P& problem)
      : problem_(problem),
        f_(make_state(problem)),
        moved_(make_state(problem)),
        f_moved_(make_state(problem)) {}

  /// Differences weigh the components by the thresholds of that tolerance, which has to outlive
  /// this, where it has one for each.
  void weigh_by(const Tolerance& tolerance) {
    if (tolerance.thresholds.size() == size()) weights_ = tolerance.thresholds.data();
  }

  std::size_t size() const { return size_of(problem_); }
  std::uint64_t evaluations() const { return evaluations_; }
  /// Without a statement of the problem df/dt is formed by differences, not taken for zero.
  bool autonomous() const {
    if constexpr (requires { problem_.autonomous(); }) return problem_.autonomous();
    return false;
  }

  void rhs(real t, const real* y, real* dydt) const {
    ++evaluations_;
    problem_.rhs(t, y, dydt);
  }
  void acceleration(real t, const real* q, const real* v, real* a) const requires SecondOrder<P> {
    ++evaluations_;
    problem_.acceleration(t, q, v, a);
  }
  /// Dense and row-major; by forward differences where the problem has none.
  void jacobian(double t, const double* y, double* j) const requires in_double {
    if constexpr (WithJacobian<P>) {
      problem_.jacobian(t, y, j);
    } else {
      const auto counted_rhs = [this](double time, const double* at, double* value) {
        rhs(time, at, value);
        return true;
      };
      difference_jacobian(counted_rhs, size(), t, y, j, {f_.data(), moved_.data(), f_moved_.data()},
                          weights_);
    }
  }
  /// By central differences where the problem has none: a Rosenbrock method would lose its order
  /// on a problem that depends on t and is taken for autonomous.
  void time_derivative(double t, const double* y, double* dfdt) const requires in_double {
    const std::size_t n = size();
    if constexpr (NonAutonomous<P>) {
      problem_.time_derivative(t, y, dfdt);
    } else if (autonomous()) {
      for (std::size_t i = 0; i < n; ++i) dfdt[i] = 0;
    } else {
      // Balances truncation against rounding for differences of second order.
      const double wanted =
          std::cbrt(std::numeric_limits<double>::epsilon()) * std::max(std::abs(t), 1e-3);
      const double later = t + wanted, earlier = t - wanted;
      rhs(later, y, f_.data());
      rhs(earlier, y, f_moved_.data());
      for (std::size_t i = 0; i < n; ++i) dfdt[i] = (f_[i] - f_moved_[i]) / (later - earlier);
    }
  }

  bool offers_damping() const requires WithDamping<P> {
    if constexpr (requires { problem_.offers_damping(); }) return problem_.offers_damping();
    return true;
  }
  void undamped_acceleration(double t, const double* q, double* a) const requires WithDamping<P> {
    ++evaluations_;
    problem_.undamped_acceleration(t, q, a);
  }
  std::uint64_t damp(double t, const double* q, double h, double* v,
                     double relative) const requires WithDamping<P> {
    return problem_.damp(t, q, h, v, relative);
  }
  /// The coefficients that it does not set are zero.
  void taylor(double t, const double* y, int order, double* c) const requires WithTaylorSeries<P> {
    const std::size_t n = size();
    for (std::size_t i = 0; i < n; ++i) c[i] = y[i];
    for (std::size_t i = n; i < n * static_cast<std::size_t>(order + 1); ++i) c[i] = 0;
    evaluations_ += static_cast<std::uint64_t>(order);
    problem_.taylor(t, y, order, c);
  }
  void linear_matrix(double* a) const requires LinearConstant<P> { problem_.linear_matrix(a); }
  const Sparsity* sparsity() const requires WithSparsity<P> { return problem_.sparsity(); }
  void jacobian_entries(double t, const double* y,
                        double* values) const requires WithJacobianEntries<P> {
    problem_.jacobian_entries(t, y, values);
  }
  auto shifted_solver() const requires WithShiftedSolver<P> { return problem_.shifted_solver(); }
  static constexpr bool tripped() { return false; }

 private:
  const P& problem_;
  mutable State<P> f_, moved_, f_moved_;
  const double* weights_ = nullptr;
  mutable std::uint64_t evaluations_ = 0;
};

}  // namespace odeum
