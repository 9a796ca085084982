// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <algorithm>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>

#include "odeum/core/counted_solver.hpp"
#include "odeum/core/guard.hpp"
#include "odeum/problem/shared.hpp"

namespace odeum {

namespace detail {
template <class P, class = void>
struct VelocityDependence {};
template <class P>
struct VelocityDependence<P, std::void_t<decltype(P::velocity_dependent)>> {
  static constexpr bool velocity_dependent = P::velocity_dependent;
};

/// What a guarded function returns for one that returns a Result.
template <class Result>
using Answer = std::conditional_t<std::is_void_v<Result>, int, Result>;

/// What a call of a capability costs a run, as the entries of capabilities.hpp name it.
namespace charge {
struct nothing {};
struct jacobian {};
struct product {};       ///< one product of the Jacobian with a vector
struct products {};      ///< as many as the call returns
struct acceleration {};  ///< an evaluation of half of the right-hand side
struct part {};          ///< an evaluation, of a part of the right-hand side
struct series {};        ///< an evaluation for each coefficient: one pass of the recurrence
struct solver {};        ///< the products of its solves
}  // namespace charge
}  // namespace detail

/// A problem with the capabilities of P, each call watched by a policy: a Guard, or what has its
/// functions evaluate, count_jacobian, count_products, tripped and counted(solver, watch).
/// Functions that fill an array return 0, or 1 once the budget is spent, when evaluations give
/// zeros; steppers check `tripped()` after each step.
template <class P, class Watch = Guard&>
class Guarded : public detail::VelocityDependence<P> {
 public:
  static constexpr std::size_t dimension = P::dimension;
  using real = RealOf<P>;

  Guarded(const P& problem, Watch watch) : problem_(problem), watch_(watch) {}

  std::size_t size() const {
    if constexpr (P::dimension == dynamic)
      return problem_.size();
    else
      return P::dimension;
  }
  [[gnu::always_inline]] int rhs(real t, const real* y, real* dydt) const {
    return watch_.evaluate(
        t, dydt, [this] { return size(); }, false, [&] { problem_.rhs(t, y, dydt); });
  }
#define ODEUM_GUARDED(concept_name, function, charge_name, ...)                            \
  template <class Q = P, class... Arguments>                                               \
  auto function(Arguments... all)                                                          \
      const->detail::Answer<decltype(std::declval<const Q&>().function(all...))> {         \
    return charged(                                                                        \
        detail::charge::charge_name(), [&] { return problem_.function(all...); }, all...); \
  }                                                                                        \
  ODEUM_FORWARD(offers_##function)
#define ODEUM_FORWARD(function)                                          \
  template <class Q = P>                                                 \
  auto function() const->decltype(std::declval<const Q&>().function()) { \
    return problem_.function();                                          \
  }
  ODEUM_CAPABILITIES(ODEUM_GUARDED)
  ODEUM_FORWARD(sparsity)
  ODEUM_FORWARD(autonomous)
#undef ODEUM_FORWARD
#undef ODEUM_GUARDED

  bool tripped() const { return watch_.tripped(); }
  Watch& watch() { return watch_; }
  const Watch& watch() const { return watch_; }

 private:
  template <class Call, class... Arguments>
  int charged(detail::charge::nothing, const Call& call, Arguments...) const {
    call();
    return tripped();
  }
  template <class Call, class... Arguments>
  int charged(detail::charge::jacobian, const Call& call, Arguments...) const {
    watch_.count_jacobian();
    call();
    return tripped();
  }
  template <class Call, class... Arguments>
  int charged(detail::charge::product, const Call& call, Arguments...) const {
    watch_.count_products(1);
    call();
    return tripped();
  }
  template <class Call, class... Arguments>
  std::uint64_t charged(detail::charge::products, const Call& call, Arguments...) const {
    const std::uint64_t count = call();
    watch_.count_products(count);
    return count;
  }
  template <class Call, class... Arguments>
  int charged(detail::charge::acceleration, const Call& call, real t, Arguments... all) const {
    real* const a = std::get<sizeof...(Arguments) - 1>(std::tuple<Arguments...>(all...));
    return watch_.evaluate(
        t, a, [this] { return size() / 2; }, true, call);
  }
  template <class Call>
  int charged(detail::charge::part, const Call& call, real t, const real*, real* f) const {
    return watch_.evaluate(
        t, f, [this] { return size(); }, false, call);
  }
  /// The coefficients that the problem does not set are zero.
  template <class Call>
  int charged(detail::charge::series, const Call& call, real t, const real* y, int order,
              real* c) const {
    const std::size_t n = size();
    std::copy(y, y + n, c);
    std::fill(c + n, c + n * static_cast<std::size_t>(order + 1), real(0));
    if (order == 0) return charged(detail::charge::nothing(), call);
    return watch_.evaluate(
        t, c + n, [&] { return n; }, false, call, order);
  }
  template <class Call>
  std::unique_ptr<ShiftedSolver> charged(detail::charge::solver, const Call& call) const {
    return counted(call(), watch_);
  }

  const P& problem_;
  Watch watch_;
};

/// A problem for timed runs with an inlined right-hand side: no guard.
template <class P>
struct Bare : P {};

template <class P>
class Guarded<Bare<P>, Guard&> : public P {
 public:
  Guarded(const Bare<P>& problem, Guard&) : P(problem) {}
  static constexpr bool tripped() { return false; }
};

namespace detail {
struct ViewAndGuard {
  ViewAndGuard(const OdeView& view, const Budget& budget, const Tolerance* tolerance)
      : problem{view, nullptr}, guarding(view.dimension, budget, tolerance) {}
  SharedOde problem;
  Guard guarding;
};
}  // namespace detail

/// A guarded problem for C interfaces, with its guard. A Jacobian is not evaluated once the budget
/// is spent.
class GuardedView : private detail::ViewAndGuard, public Guarded<SharedOde> {
 public:
  GuardedView(const OdeView& view, const Budget& budget, const Tolerance* tolerance = nullptr)
      : ViewAndGuard(view, budget, tolerance),
        Guarded<SharedOde>(ViewAndGuard::problem, ViewAndGuard::guarding) {}
  GuardedView(const GuardedView&) = delete;
  GuardedView& operator=(const GuardedView&) = delete;

  int jacobian(double t, const double* y, double* j) const {
    return tripped() ? 1 : Guarded::jacobian(t, y, j);
  }
  int jacobian_entries(double t, const double* y, double* values) const {
    return tripped() ? 1 : Guarded::jacobian_entries(t, y, values);
  }
  const OdeView& view() const { return problem.view(); }
  Guard& guard() { return guarding; }
};

}  // namespace odeum
