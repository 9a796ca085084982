// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>

#include "odeum/problem/shifted_solver.hpp"

/// The functions that a problem may offer beside its right-hand side. A new one is an entry here:
///
///     ENTRY(concept, function, charge, signature)
///
/// The entry gives the problem's concept and `offers_FUNCTION` (concepts.hpp), the pointer in
/// OdeView, the functions of the shared types (shared.hpp) and of a guarded problem, where `charge`
/// says what a call costs a run (core/guarded.hpp). `real` is the number type of the problem.
///
/// - `jacobian` fills j with df/dy, dense and row-major.
/// - `jacobian_times` fills `product` with the product of df/dy and x.
/// - `jacobian_entries` fills the values of `sparsity()`, see sparsity.hpp; without it they are
///   formed by differences of f, several columns at a time.
/// - `time_derivative` fills dfdt with df/dt. A problem without it is assumed autonomous.
/// - `shifted_solver` makes the problem's own solver of (I - gamma_h J) x = r, see
///   shifted_solver.hpp; null: it has none.
/// - `taylor` fills c[k * dimension + i] with the k-th coefficient y_i^(k)(t) / k! of the solution
///   through y at t, for k = 0, ..., order, which is at most highest_taylor_order.
/// - `linear_matrix` fills a with A of y' = A y + b, A and b constant, dense and row-major; b is
///   the right-hand side at y = 0.
/// - `acceleration` fills a with a(t, q, v) of q'' = a(t, q, v), where y = [q, v].
/// - `undamped_acceleration` and `damp` split q'' = a(t, q) + d(t, q, v) with d(t, q, 0) = 0: the
///   first fills a; the second takes one step of length h of the trapezoidal rule for v' = d(t, q,
///   v) at fixed t and q, with an error of at most `relative` of the change of v, and returns the
///   number of products with dd/dv.
/// - `explicit_part` and `implicit_part` split f into a part that additive (IMEX) methods take
///   explicitly and a stiff one that they solve for; each fills f, and their sum is the right-hand
///   side. `implicit_jacobian` fills j with the derivative of the second, dense and row-major;
///   without it that is formed by differences.
/// - `project` moves y onto the constraints of the problem, the hidden ones among them, by Newton's
///   method, and returns the number of its iterations, 0 where it failed. Runs of one-step methods
///   then project after each step.
// clang-format off
#define ODEUM_CAPABILITIES(ENTRY)                                                                    \
  ENTRY(WithJacobian, jacobian, jacobian, void(real t, const real* y, real* j))                      \
  ENTRY(WithJacobianTimes, jacobian_times, product,                                                  \
        void(real t, const real* y, const real* x, real* product))                                   \
  ENTRY(WithJacobianEntries, jacobian_entries, jacobian, void(real t, const real* y, real* values))  \
  ENTRY(NonAutonomous, time_derivative, nothing, void(real t, const real* y, real* dfdt))            \
  ENTRY(WithShiftedSolver, shifted_solver, solver, std::unique_ptr<ShiftedSolver>())                 \
  ENTRY(WithTaylorSeries, taylor, series, void(real t, const real* y, int order, real* c))           \
  ENTRY(LinearConstant, linear_matrix, nothing, void(real* a))                                       \
  ENTRY(WithAcceleration, acceleration, acceleration,                                                \
        void(real t, const real* q, const real* v, real* a))                                         \
  ENTRY(WithUndampedAcceleration, undamped_acceleration, acceleration,                               \
        void(real t, const real* q, real* a))                                                        \
  ENTRY(WithExplicitPart, explicit_part, part, void(real t, const real* y, real* f))                 \
  ENTRY(WithImplicitPart, implicit_part, part, void(real t, const real* y, real* f))                 \
  ENTRY(WithImplicitJacobian, implicit_jacobian, jacobian,                                           \
        void(real t, const real* y, real* j))                                                        \
  ENTRY(WithDampingStep, damp, products,                                                             \
        std::uint64_t(real t, const real* q, real h, real* v, double relative))                      \
  ENTRY(WithProjection, project, products, std::uint64_t(real t, real* y))
// clang-format on

namespace odeum {

/// Marks a problem whose dimension is known at run time only; it then has a `size()`.
inline constexpr std::size_t dynamic = static_cast<std::size_t>(-1);

inline constexpr int highest_taylor_order = 63;

namespace detail {
template <class P, class = void>
struct RealOf {
  using type = double;
};
template <class P>
struct RealOf<P, std::void_t<typename P::real>> {
  using type = typename P::real;
};
}  // namespace detail

/// The number type of a problem: double, unless it names another one as `real`.
template <class P>
using RealOf = typename detail::RealOf<P>::type;

/// The signature of each capability for a number type.
namespace capability {
#define ODEUM_SIGNATURE(concept_name, function, charge, ...) \
  template <class real>                                      \
  using function = __VA_ARGS__;
ODEUM_CAPABILITIES(ODEUM_SIGNATURE)
#undef ODEUM_SIGNATURE

/// A function of that signature behind a pointer, whose first argument is the problem.
template <class Signature>
struct Pointer;
template <class Result, class... Arguments>
struct Pointer<Result(Arguments...)> {
  using type = Result (*)(const void* problem, Arguments...);
};
}  // namespace capability

}  // namespace odeum
