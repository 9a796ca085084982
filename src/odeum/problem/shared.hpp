// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "odeum/problem/concepts.hpp"
#include "odeum/problem/difference_jacobian.hpp"
#include "odeum/problem/shifted_solver.hpp"

/// Problems behind function pointers that fulfil the concepts again: every case is run as one of
/// three types, so that methods, own and peers', are compiled for these three and not for every
/// case.
///
/// Concepts are checked at compile time, so these types offer all that has a fallback: a Jacobian
/// (by differences where the problem has none), df/dt (zero where autonomous), a shifted solver
/// (null where there is none). What a problem itself has is known at run time, from its view(). A
/// capability without a fallback is a pointer of OdeView, a member here, and a line in a method's
/// `fits_problem`, see kernel/method.hpp.
namespace odeum {

class SharedOde {
 public:
  static constexpr std::size_t dimension = dynamic;

  /// `keep_alive` owns the problem that is viewed.
  SharedOde(const OdeView& view, std::shared_ptr<const void> keep_alive)
      : view_(view), keep_alive_(std::move(keep_alive)) {}

  const OdeView& view() const { return view_; }
  std::size_t size() const { return view_.dimension; }
  bool autonomous() const { return !view_.time_derivative; }
  bool offers_jacobian() const { return view_.jacobian != nullptr; }

  void rhs(double t, const double* y, double* dydt) const { view_.rhs(view_.problem, t, y, dydt); }
  void jacobian(double t, const double* y, double* j) const {
    if (view_.jacobian)
      view_.jacobian(view_.problem, t, y, j);
    else
      difference_jacobian(*this, t, y, j);
  }
  void time_derivative(double t, const double* y, double* dfdt) const {
    if (view_.time_derivative)
      view_.time_derivative(view_.problem, t, y, dfdt);
    else
      std::fill(dfdt, dfdt + size(), 0.0);
  }
  const Sparsity* sparsity() const { return view_.sparsity; }
  bool offers_entries() const { return view_.jacobian_entries != nullptr; }
  void jacobian_entries(double t, const double* y, double* values) const {
    view_.jacobian_entries(view_.problem, t, y, values);
  }
  std::unique_ptr<ShiftedSolver> shifted_solver() const {
    return std::unique_ptr<ShiftedSolver>(view_.shifted_solver ? view_.shifted_solver(view_.problem)
                                                               : nullptr);
  }

  // Without a fallback: a method that needs one asks `offers` in its fits_problem.
  bool offers_taylor() const { return view_.taylor != nullptr; }
  void taylor(double t, const double* y, int order, double* c) const {
    view_.taylor(view_.problem, t, y, order, c);
  }
  bool offers_linear_matrix() const { return view_.linear_matrix != nullptr; }
  void linear_matrix(double* a) const { view_.linear_matrix(view_.problem, a); }

 private:
  OdeView view_;
  std::shared_ptr<const void> keep_alive_;
};

/// q'' = a(t, q, v).
class SharedSecondOrder : public SharedOde {
 public:
  using SharedOde::SharedOde;
  static constexpr bool velocity_dependent = true;
  void acceleration(double t, const double* q, const double* v, double* a) const {
    view().acceleration(view().problem, t, q, v, a);
  }

  bool offers_damping() const { return view().damp != nullptr; }
  void undamped_acceleration(double t, const double* q, double* a) const {
    view().undamped_acceleration(view().problem, t, q, a);
  }
  std::uint64_t damp(double t, const double* q, double h, double* v, double relative) const {
    return view().damp(view().problem, t, q, h, v, relative);
  }
};

/// q'' = a(t, q).
class SharedSeparable : public SharedOde {
 public:
  using SharedOde::SharedOde;
  static constexpr bool velocity_dependent = false;
  void acceleration(double t, const double* q, const double* v, double* a) const {
    view().acceleration(view().problem, t, q, v, a);
  }
};

template <class P>
concept Shared = std::derived_from<P, SharedOde>;

}  // namespace odeum
