// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, and slow with uBLAS's own checks on: for units that are compiled so.
#include <algorithm>
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_dense_output.hpp>
#include <utility>
#include <vector>

#include "odeint/implicit.hpp"
#include "odeint/walk.hpp"
#include "odeum/solvers/first_step.hpp"

/// odeint's rosenbrock4 to a tolerance, on a system of any type: a pair (right-hand side, Jacobian
/// and df/dt), as the library takes it.
namespace odeum::adapters::odeint {

namespace od = boost::numeric::odeint;
using Vector = boost::numeric::ublas::vector<double>;
using Matrix = boost::numeric::ublas::matrix<double>;  // row-major, as the problem's own

/// rosenbrock4 for the controller, which divides the estimate by one absolute tolerance and the
/// relative one: estimates scaled so that it then divides by the absolute tolerance of the
/// component.
class ByComponent : public od::rosenbrock4<double> {
 public:
  explicit ByComponent(const Tolerance& tolerance = Tolerance(1)) : tolerance_(tolerance) {}
  template <class System>
  void do_step(System system, const Vector& y, double t, Vector& y_new, double h, Vector& error) {
    od::rosenbrock4<double>::do_step(system, y, t, y_new, h, error);
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double size = std::max(std::abs(y[i]), std::abs(y_new[i]));
      error[i] *= (1 + size) / (tolerance_.threshold(i) + size);
    }
  }

 private:
  Tolerance tolerance_;
};

template <class Stepper>
using Controller = od::rosenbrock4_controller<Stepper>;

/// Calls run(controller), of the request's tolerance.
template <class Run>
void with_controller(const Request& request, Run&& run) {
  const Tolerance& tolerance = request.tolerance;
  if (tolerance.by_component())
    run(Controller<ByComponent>(tolerance.relative, tolerance.relative, ByComponent(tolerance)));
  else
    run(Controller<od::rosenbrock4<double>>(tolerance.absolute(0), tolerance.relative));
}

inline constexpr int rosenbrock4_order = 4;

template <class System>
void walk_rosenbrock4(const System& system, double t0, double first_step, const Request& request,
                      Vector& y, Outcome& outcome) {
  with_controller(request, [&](auto stepper) {
    walk_controlled(stepper, system, t0, first_step, request, y, outcome);
  });
}

template <class System>
void walk_rosenbrock4_dense_output(const System& system, double t0, double first_step,
                                   const Request& request, Vector& y, Outcome& outcome) {
  with_controller(request, [&](auto controller) {
    od::rosenbrock4_dense_output<decltype(controller)> stepper(controller);
    walk_dense(stepper, system, t0, first_step, request, y, outcome);
  });
}

/// For timed runs: an autonomous problem P with nothing between it and the library.
template <class P>
struct BareRhs {
  const P* problem;
  void operator()(const Vector& y, Vector& dydt, double t) const {
    problem->rhs(t, y.data().begin(), dydt.data().begin());
  }
};
template <class P>
struct BareJacobian {
  const P* problem;
  void operator()(const Vector& y, Matrix& j, double t, Vector& dfdt) const {
    problem->jacobian(t, y.data().begin(), &j(0, 0));
    std::fill(dfdt.begin(), dfdt.end(), 0.0);
  }
};

template <class P, class Walk>
Outcome run_bare(const OdeView& view, double t0, const std::vector<double>& y0,
                 const Request& request, Walk&& walk) {
  const P& problem = *static_cast<const P*>(view.problem);
  GuardedView guarded(view, request.budget);
  Outcome outcome;
  Vector y(y0.size());
  std::copy(y0.begin(), y0.end(), y.begin());
  try {
    const std::pair<BareRhs<P>, BareJacobian<P>> system{{&problem}, {&problem}};
    const double first =
        first_step(guarded, t0, y0, request.stops.back(), rosenbrock4_order, request.tolerance);
    walk(system, t0, first, request, y, outcome);
  } catch (...) {
    explain_exception(outcome);
  }
  guarded.guard().conclude(request, outcome);
  return outcome;
}

/// The steppers with the right-hand side of P inlined; `view` is one of a P.
template <class P>
Outcome run_bare_rosenbrock4(const OdeView& view, double t0, const std::vector<double>& y0,
                             const Request& request) {
  if (request.mode == Mode::fixed) return refuse_fixed();
  return run_bare<P>(view, t0, y0, request,
                     [](auto&&... all) { walk_rosenbrock4(std::forward<decltype(all)>(all)...); });
}
template <class P>
Outcome run_bare_rosenbrock4_dense_output(const OdeView& view, double t0,
                                          const std::vector<double>& y0, const Request& request) {
  if (request.mode == Mode::fixed) return refuse_fixed();
  return run_bare<P>(view, t0, y0, request, [](auto&&... all) {
    walk_rosenbrock4_dense_output(std::forward<decltype(all)>(all)...);
  });
}

}  // namespace odeum::adapters::odeint
