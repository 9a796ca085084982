// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "odeum/problem/capabilities.hpp"
#include "odeum/problem/ode_view.hpp"
#include "odeum/problem/sparsity.hpp"

/// A problem is a small struct with a right-hand side and whatever else it can offer.
///
///     struct Decay {
///       static constexpr std::size_t dimension = 1;       // or odeum::dynamic, with a size()
///       double lambda;
///       void rhs(double t, const double* y, double* dydt) const { dydt[0] = lambda * y[0]; }
///       void jacobian(double t, const double* y, double* j) const { j[0] = lambda; }
///     };
///
/// All times, states and parameters are in the units of the problem's own equation.
namespace odeum {

namespace detail {
template <class Real, std::size_t N>
using StateOf = std::conditional_t<N == dynamic, std::vector<Real>, std::array<Real, N>>;
/// Whether the result of a call may stand for an R.
template <class Result, class R>
concept Gives = std::is_void_v<R> || std::convertible_to<Result, R>;
}  // namespace detail

/// The state of a problem: std::array for a static dimension, std::vector for a dynamic one.
template <class P>
using State = detail::StateOf<RealOf<P>, P::dimension>;

/// y' = f(t, y): `rhs` fills dydt from y, both of `dimension` numbers, never overlapping.
template <class P>
concept Ode = requires(const P& p, RealOf<P> t, const RealOf<P>* y, RealOf<P>* dydt) {
  { P::dimension } -> std::convertible_to<std::size_t>;
  p.rhs(t, y, dydt);
};

// For each capability its concept, as WithJacobian<P>, and offers_jacobian(problem): whether the
// problem offers it, which a type that stands for many problems decides at run time by a function
// of that name.
#define ODEUM_CONCEPT(concept_name, function, charge, ...)                                     \
  namespace detail {                                                                           \
  template <class P, class Signature>                                                          \
  inline constexpr bool has_##function = false;                                                \
  template <class P, class Result, class... Arguments>                                         \
  requires requires(const P& p, Arguments... all) {                                            \
    { p.function(all...) } -> Gives<Result>;                                                   \
  }                                                                                            \
  inline constexpr bool has_##function<P, Result(Arguments...)> = true;                        \
  }                                                                                            \
  template <class P>                                                                           \
  concept concept_name = Ode<P> && detail::has_##function<P, capability::function<RealOf<P>>>; \
  template <Ode P>                                                                             \
  constexpr bool offers_##function([[maybe_unused]] const P& problem) {                        \
    if constexpr (concept_name<P> && requires { problem.offers_##function(); })                \
      return problem.offers_##function();                                                      \
    else                                                                                       \
      return concept_name<P>;                                                                  \
  }
ODEUM_CAPABILITIES(ODEUM_CONCEPT)
#undef ODEUM_CONCEPT

/// States which entries of df/dy may differ from zero: a pointer to a Sparsity, null where that is
/// not known or all may. Implicit methods then solve with banded or sparse factors.
template <class P>
concept WithSparsity = Ode<P> && requires(const P& p) {
  { p.sparsity() } -> std::convertible_to<const Sparsity*>;
};

/// q'' = a(t, q, v) with y = [q, v]: all positions, then all velocities.
template <class P>
concept SecondOrder = WithAcceleration<P> && requires {
  { P::velocity_dependent } -> std::convertible_to<bool>;
};

/// q'' = a(t, q): the acceleration does not depend on the velocity.
template <class P>
concept Separable = SecondOrder<P> && !P::velocity_dependent;

/// q'' = a(t, q) + d(t, q, v) with d(t, q, 0) = 0, see `damp` in capabilities.hpp.
template <class P>
concept WithDamping = SecondOrder<P> && WithUndampedAcceleration<P> && WithDampingStep<P>;

/// f = explicit part + implicit part, see capabilities.hpp.
template <class P>
concept Split = WithExplicitPart<P> && WithImplicitPart<P>;

/// Offers an energy, in the problem's units.
template <class P>
concept WithEnergy = Ode<P> && requires(const P& p, const double* y) {
  { p.energy(y) } -> std::convertible_to<double>;
};

template <Ode P>
constexpr std::size_t size_of(const P& problem) {
  if constexpr (P::dimension == dynamic)
    return problem.size();
  else
    return P::dimension;
}

/// Whether the right-hand side does not depend on t. A type that stands for many problems decides
/// it at run time.
template <Ode P>
constexpr bool is_autonomous(const P& problem) {
  if constexpr (requires { problem.autonomous(); })
    return problem.autonomous();
  else
    return !NonAutonomous<P>;
}

/// A zero state of the right size.
template <Ode P>
State<P> make_state(const P& problem) {
  State<P> y{};
  if constexpr (P::dimension == dynamic) y.assign(problem.size(), RealOf<P>(0));
  return y;
}

/// The right-hand side of q'' = a(t, q, v) as a first-order system: dydt = [v, a].
template <class P>
void second_order_rhs(const P& problem, std::size_t degrees, RealOf<P> t, const RealOf<P>* y,
                      RealOf<P>* dydt) {
  for (std::size_t i = 0; i < degrees; ++i) dydt[i] = y[degrees + i];
  problem.acceleration(t, y, y + degrees, dydt + degrees);
}

namespace detail {
/// Points at a function of P, which `call` calls.
template <class P, class Result, class... Arguments, class Call>
void point(Result (*&pointer)(const void*, Arguments...), Call) {
  pointer = [](const void* p, Arguments... all) -> Result {
    if constexpr (std::is_void_v<Result>)
      Call{}(*static_cast<const P*>(p), all...);
    else
      return Call{}(*static_cast<const P*>(p), all...);
  };
}

template <class P>
requires WithSparsity<P> && WithJacobianEntries<P> std::vector<double> entries_at(const P& problem,
                                                                                  double t,
                                                                                  const double* y) {
  std::vector<double> values(problem.sparsity()->entries());
  problem.jacobian_entries(t, y, values.data());
  return values;
}

/// What a sparse Jacobian is known by, and its product and dense form where the problem has none.
template <WithSparsity P>
void view_sparsity(const P& problem, OdeView& view) {
  view.sparsity = problem.sparsity();
  if (!view.sparsity) view.jacobian_entries = nullptr;
  if constexpr (WithJacobianEntries<P>) {
    if (!view.jacobian_entries) return;
    if (!view.jacobian)
      point<P>(view.jacobian, [](const P& self, double t, const double* y, double* j) {
        fill_dense(*self.sparsity(), entries_at(self, t, y).data(), j);
      });
    if (!view.jacobian_times)
      point<P>(view.jacobian_times,
               [](const P& self, double t, const double* y, const double* x, double* product) {
                 multiply(*self.sparsity(), entries_at(self, t, y).data(), x, product);
               });
  }
}
}  // namespace detail

/// The problem behind function pointers; it must outlive the view.
template <Ode P>
OdeView view_of(const P& problem) {
  if constexpr (requires { problem.view(); }) return problem.view();
  OdeView view;
  view.problem = &problem;
  view.dimension = size_of(problem);
  detail::point<P>(view.rhs, [](const P& self, double t, const double* y, double* dydt) {
    self.rhs(t, y, dydt);
  });
#define ODEUM_VIEW(concept_name, function, charge, ...) \
  if constexpr (concept_name<P>)                        \
    if (offers_##function(problem))                     \
      detail::point<P>(view.function,                   \
                       [](const P& self, auto... all) { return self.function(all...); });
  ODEUM_CAPABILITIES(ODEUM_VIEW)
#undef ODEUM_VIEW
  if constexpr (WithSparsity<P>) detail::view_sparsity(problem, view);
  if constexpr (SecondOrder<P>) {
    if (!view.acceleration) return view;
    view.degrees_of_freedom = view.dimension / 2;
    view.velocity_dependent = P::velocity_dependent;
    if constexpr (requires { problem.depends_on_velocity(); })
      view.velocity_dependent = problem.depends_on_velocity();
  }
  return view;
}

}  // namespace odeum
