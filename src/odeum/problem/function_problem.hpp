// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>

#include "odeum/problem/concepts.hpp"

namespace odeum {

/// A problem of std::functions: one type for every right-hand side, so that a method is compiled
/// for it once. For proofs, where the cost of a call does not matter. Jacobian and df/dt (zero
/// where autonomous) must be set.
struct FunctionProblem {
  static constexpr std::size_t dimension = dynamic;
  std::size_t unknowns = 0;
  std::function<void(double t, const double* y, double* dydt)> f;
  std::function<void(double t, const double* y, double* j)> f_y;  ///< dense, row-major
  std::function<void(double t, const double* y, double* dfdt)> f_t;

  std::size_t size() const { return unknowns; }
  void rhs(double t, const double* y, double* dydt) const { f(t, y, dydt); }
  void jacobian(double t, const double* y, double* j) const { f_y(t, y, j); }
  void time_derivative(double t, const double* y, double* dfdt) const { f_t(t, y, dfdt); }
};

/// The same of second order, q'' = a(t, q, v) with y = [q, v].
template <bool VelocityDependent>
struct FunctionMechanics : FunctionProblem {
  static constexpr bool velocity_dependent = VelocityDependent;
  std::function<void(double t, const double* q, const double* v, double* a)> a;

  void acceleration(double t, const double* q, const double* v, double* out) const {
    a(t, q, v, out);
  }
};

}  // namespace odeum
