// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// The implicit part of a split problem as a problem, for the solvers of implicit stages. A sparse
/// Jacobian has the entries of that of the whole right-hand side and is formed by differences. The
/// problem must outlive it.
template <Ode P>
class ImplicitPart {
 public:
  static constexpr std::size_t dimension = P::dimension;
  using real = RealOf<P>;

  explicit ImplicitPart(const P& problem) : problem_(problem) {}

  std::size_t size() const { return size_of(problem_); }
  void rhs(real t, const real* y, real* f) const { problem_.implicit_part(t, y, f); }
  void jacobian(real t, const real* y, real* j) const requires WithImplicitJacobian<P> {
    problem_.implicit_jacobian(t, y, j);
  }
  bool offers_jacobian() const { return offers_implicit_jacobian(problem_); }
  const Sparsity* sparsity() const requires WithSparsity<P> { return problem_.sparsity(); }
  /// What counts the evaluations of differences, of a problem that is watched.
  template <class Q = P>
  auto watch() const -> decltype(std::declval<const Q&>().watch()) {
    return problem_.watch();
  }

 private:
  const P& problem_;
};

}  // namespace odeum
