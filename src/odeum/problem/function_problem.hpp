// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "odeum/problem/concepts.hpp"

namespace odeum {

/// A problem of std::functions: one type for every right-hand side, so that a method is compiled
/// for it once. For proofs, where the cost of a call does not matter. Jacobian and df/dt (zero
/// where autonomous) must be set. It is split by components: of some a quarter is implicit, the
/// others are as a whole.
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
  void explicit_part(double t, const double* y, double* dydt) const {
    f(t, y, dydt);
    for (std::size_t i = 0; i < unknowns; ++i) dydt[i] *= 1 - implicit_share(i);
  }
  void implicit_part(double t, const double* y, double* dydt) const {
    f(t, y, dydt);
    for (std::size_t i = 0; i < unknowns; ++i) dydt[i] *= implicit_share(i);
  }
  void implicit_jacobian(double t, const double* y, double* j) const {
    f_y(t, y, j);
    for (std::size_t i = 0; i < unknowns * unknowns; ++i) j[i] *= implicit_share(i / unknowns);
  }
  static double implicit_share(std::size_t i) { return i % 2 == 0 ? 0.25 : 1; }
};

/// The same of second order, q'' = a(t, q, v) with y = [q, v].
template <bool VelocityDependent>
struct FunctionMechanics : FunctionProblem {
  static constexpr bool velocity_dependent = VelocityDependent;
  std::function<void(double t, const double* q, const double* v, double* a)> a;

  void acceleration(double t, const double* q, const double* v, double* out) const {
    a(t, q, v, out);
  }
  void undamped_acceleration(double t, const double* q, double* out) const {
    a(t, q, std::vector<double>(unknowns / 2).data(), out);
  }
  /// Solves by fixed-point iteration, which converges for the steps of proofs.
  std::uint64_t damp(double t, const double* q, double h, double* v, double /*relative*/) const {
    const std::size_t n = unknowns / 2;
    std::vector<double> undamped(n), before(n), after(n), next(v, v + n);
    undamped_acceleration(t, q, undamped.data());
    a(t, q, v, before.data());
    for (int i = 0; i < 40; ++i) {
      a(t, q, next.data(), after.data());
      for (std::size_t k = 0; k < n; ++k)
        next[k] = v[k] + h * ((before[k] + after[k]) / 2 - undamped[k]);
    }
    std::ranges::copy(next, v);
    return 0;
  }
};

}  // namespace odeum
