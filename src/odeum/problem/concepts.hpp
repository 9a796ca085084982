// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

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

/// Marks a problem whose dimension is known at run time only; it then has a `size()`.
inline constexpr std::size_t dynamic = static_cast<std::size_t>(-1);

namespace detail {
template <class P>
struct RealOf {
  using type = double;
};
template <class P>
requires requires { typename P::real; }
struct RealOf<P> {
  using type = typename P::real;
};
template <class Real, std::size_t N>
using StateOf = std::conditional_t<N == dynamic, std::vector<Real>, std::array<Real, N>>;
}  // namespace detail

/// The number type of a problem: double, unless it names another one as `real`.
template <class P>
using RealOf = typename detail::RealOf<P>::type;

/// The state of a problem: std::array for a static dimension, std::vector for a dynamic one.
template <class P>
using State = detail::StateOf<RealOf<P>, P::dimension>;

/// y' = f(t, y): `rhs` fills dydt from y, both of `dimension` numbers, never overlapping.
template <class P>
concept Ode = requires(const P& p, RealOf<P> t, const RealOf<P>* y, RealOf<P>* dydt) {
  { P::dimension } -> std::convertible_to<std::size_t>;
  p.rhs(t, y, dydt);
};

/// Offers df/dy, dense and row-major.
template <class P>
concept WithJacobian = Ode<P> && requires(const P& p, double t, const double* y, double* j) {
  p.jacobian(t, y, j);
};

/// Offers the product of df/dy with a vector.
template <class P>
concept WithJacobianTimes = Ode<P> &&
    requires(const P& p, double t, const double* y, const double* x, double* product) {
  p.jacobian_times(t, y, x, product);
};

/// States which entries of df/dy may differ from zero: a pointer to a Sparsity, null where that is
/// not known or all may. Implicit methods then solve with banded or sparse factors.
template <class P>
concept WithSparsity = Ode<P> && requires(const P& p) {
  { p.sparsity() } -> std::convertible_to<const Sparsity*>;
};

/// Offers the values of those entries, in the order of the Sparsity; without it they are formed by
/// differences of f, several columns at a time.
template <class P>
concept WithJacobianEntries = WithSparsity<P> &&
    requires(const P& p, double t, const double* y, double* values) {
  p.jacobian_entries(t, y, values);
};

/// Offers df/dt. A problem without it is assumed autonomous; see is_autonomous().
template <class P>
concept NonAutonomous = Ode<P> && requires(const P& p, double t, const double* y, double* d) {
  p.time_derivative(t, y, d);
};

/// q'' = a(t, q, v) with y = [q, v]: all positions, then all velocities.
template <class P>
concept SecondOrder = Ode<P> &&
    requires(const P& p, RealOf<P> t, const RealOf<P>* q, const RealOf<P>* v, RealOf<P>* a) {
  { P::velocity_dependent } -> std::convertible_to<bool>;
  p.acceleration(t, q, v, a);
};

/// q'' = a(t, q): the acceleration does not depend on the velocity.
template <class P>
concept Separable = SecondOrder<P> && !P::velocity_dependent;

/// q'' = a(t, q) + d(t, q, v) with d(t, q, 0) = 0: `undamped_acceleration` fills a, and `damp`
/// takes one step of length h of the trapezoidal rule for v' = d(t, q, v) at fixed t and q. The
/// error of the change of v is `relative` of it; the number of products with dd/dv is returned.
template <class P>
concept WithDamping = SecondOrder<P> &&
    requires(const P& p, RealOf<P> t, const RealOf<P>* q, RealOf<P>* v, double relative) {
  p.undamped_acceleration(t, q, v);
  { p.damp(t, q, t, v, relative) } -> std::convertible_to<std::uint64_t>;
};

/// Offers its own solver of (I - gamma_h J) x = r, see problem/shifted_solver.hpp: a pointer, null
/// where it has none.
template <class P>
concept WithShiftedSolver = Ode<P> && requires(const P& p) {
  p.shifted_solver();
};

/// Offers its Taylor series: `taylor(t, y, order, c)` fills c[k * dimension + i] with the k-th
/// coefficient y_i^(k)(t) / k! of the solution through y at t, for k = 0, ..., order, which is at
/// most highest_taylor_order.
inline constexpr int highest_taylor_order = 63;
template <class P>
concept WithTaylorSeries = Ode<P> &&
    requires(const P& p, double t, const double* y, int order, double* c) {
  p.taylor(t, y, order, c);
};

/// y' = A y + b with constant A and b. `linear_matrix` fills A, dense and row-major; b is the
/// right-hand side at y = 0.
template <class P>
concept LinearConstant = Ode<P> && requires(const P& p, double* a) {
  p.linear_matrix(a);
};

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
template <WithJacobianEntries P>
std::vector<double> entries_at(const P& problem, double t, const double* y) {
  std::vector<double> values(problem.sparsity()->entries());
  problem.jacobian_entries(t, y, values.data());
  return values;
}

/// What a sparse Jacobian is known by, and its product and dense form where the problem has none.
template <WithSparsity P>
void view_sparsity(const P& problem, OdeView& view) {
  view.sparsity = problem.sparsity();
  if constexpr (WithJacobianEntries<P>) {
    if (!view.sparsity) return;
    view.jacobian_entries = [](const void* p, double t, const double* y, double* values) {
      static_cast<const P*>(p)->jacobian_entries(t, y, values);
    };
    if (!view.jacobian)
      view.jacobian = [](const void* p, double t, const double* y, double* j) {
        const P& self = *static_cast<const P*>(p);
        fill_dense(*self.sparsity(), entries_at(self, t, y).data(), j);
      };
    if (!view.jacobian_times)
      view.jacobian_times = [](const void* p, double t, const double* y, const double* x,
                               double* product) {
        const P& self = *static_cast<const P*>(p);
        multiply(*self.sparsity(), entries_at(self, t, y).data(), x, product);
      };
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
  view.rhs = [](const void* p, double t, const double* y, double* dydt) {
    static_cast<const P*>(p)->rhs(t, y, dydt);
  };
  if constexpr (WithJacobian<P>)
    view.jacobian = [](const void* p, double t, const double* y, double* j) {
      static_cast<const P*>(p)->jacobian(t, y, j);
    };
  if constexpr (WithJacobianTimes<P>)
    view.jacobian_times = [](const void* p, double t, const double* y, const double* x,
                             double* product) {
      static_cast<const P*>(p)->jacobian_times(t, y, x, product);
    };
  if constexpr (WithSparsity<P>) detail::view_sparsity(problem, view);
  if constexpr (NonAutonomous<P>)
    view.time_derivative = [](const void* p, double t, const double* y, double* dfdt) {
      static_cast<const P*>(p)->time_derivative(t, y, dfdt);
    };
  if constexpr (WithShiftedSolver<P>)
    view.shifted_solver = [](const void* p) -> ShiftedSolver* {
      return static_cast<const P*>(p)->shifted_solver().release();
    };
  if constexpr (WithTaylorSeries<P>)
    view.taylor = [](const void* p, double t, const double* y, int order, double* c) {
      static_cast<const P*>(p)->taylor(t, y, order, c);
    };
  if constexpr (LinearConstant<P>)
    view.linear_matrix = [](const void* p, double* a) {
      static_cast<const P*>(p)->linear_matrix(a);
    };
  if constexpr (SecondOrder<P>) {
    view.degrees_of_freedom = view.dimension / 2;
    view.velocity_dependent = P::velocity_dependent;
    view.acceleration = [](const void* p, double t, const double* q, const double* v, double* a) {
      static_cast<const P*>(p)->acceleration(t, q, v, a);
    };
  }
  if constexpr (WithDamping<P>) {
    if constexpr (requires { problem.offers_damping(); })
      if (!problem.offers_damping()) return view;
    view.undamped_acceleration = [](const void* p, double t, const double* q, double* a) {
      static_cast<const P*>(p)->undamped_acceleration(t, q, a);
    };
    view.damp = [](const void* p, double t, const double* q, double h, double* v,
                   double relative) -> std::uint64_t {
      return static_cast<const P*>(p)->damp(t, q, h, v, relative);
    };
  }
  return view;
}

}  // namespace odeum
