// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <algorithm>
#include <memory>
#include <utility>

#include "odeum/problem/ode_view.hpp"

/// Problems behind function pointers that fulfil the concepts again: every case is run as one of
/// three types, so that methods, own and peers', are compiled for these three and not for every
/// case.
///
/// Concepts are checked at compile time, so these types have the functions of all capabilities.
/// What a problem itself offers is known at run time, from its view() or by `offers_jacobian` and
/// the like: a method that needs it asks in its `fits_problem`, see kernel/method.hpp.
namespace odeum {

namespace detail {
/// The functions that are behind the pointers of a view.
class ViewedFunctions {
 public:
  explicit ViewedFunctions(const OdeView& view) : view_(view) {}

  const OdeView& view() const { return view_; }
  void rhs(double t, const double* y, double* dydt) const { view_.rhs(view_.problem, t, y, dydt); }
#define ODEUM_VIEWED(concept_name, function, charge, ...)              \
  bool offers_##function() const { return view_.function != nullptr; } \
  template <class... Arguments>                                        \
  auto function(Arguments... all) const {                              \
    return view_.function(view_.problem, all...);                      \
  }
  ODEUM_CAPABILITIES(ODEUM_VIEWED)
#undef ODEUM_VIEWED

 private:
  OdeView view_;
};
}  // namespace detail

class SharedOde : public detail::ViewedFunctions {
 public:
  static constexpr std::size_t dimension = dynamic;

  /// `keep_alive` owns the problem that is viewed.
  SharedOde(const OdeView& view, std::shared_ptr<const void> keep_alive)
      : ViewedFunctions(view), keep_alive_(std::move(keep_alive)) {}

  std::size_t size() const { return view().dimension; }
  bool autonomous() const { return !offers_time_derivative(); }
  const Sparsity* sparsity() const { return view().sparsity; }

  /// Zero where the problem is autonomous.
  void time_derivative(double t, const double* y, double* dfdt) const {
    if (offers_time_derivative())
      ViewedFunctions::time_derivative(t, y, dfdt);
    else
      std::fill(dfdt, dfdt + size(), 0.0);
  }
  std::unique_ptr<ShiftedSolver> shifted_solver() const {
    return offers_shifted_solver() ? ViewedFunctions::shifted_solver() : nullptr;
  }

 private:
  std::shared_ptr<const void> keep_alive_;
};

/// q'' = a(t, q, v).
class SharedSecondOrder : public SharedOde {
 public:
  using SharedOde::SharedOde;
  static constexpr bool velocity_dependent = true;
};

/// q'' = a(t, q).
class SharedSeparable : public SharedOde {
 public:
  using SharedOde::SharedOde;
  static constexpr bool velocity_dependent = false;
};

}  // namespace odeum
