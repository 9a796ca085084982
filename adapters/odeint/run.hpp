// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>

#include "odeint/system.hpp"
#include "odeint/walk.hpp"
#include "odeum/control/adaptive.hpp"
#include "odeum/solvers/solver.hpp"

/// One function for each way of using odeint's steppers, each a template on stepper and problem
/// type.
namespace odeum::adapters::odeint {

template <Ode P>
using Run = Outcome (*)(const Contest<P>&, const Request&);

/// Calls body(problem, outcome) with the problem under a guard of its own.
template <Ode P, class Body>
Outcome attempt(const Contest<P>& contest, const Request& request, Body&& body) {
  Guard guard(size_of(*contest.problem), request.budget);
  Outcome outcome;
  try {
    body(Guarded<P>(*contest.problem, guard), outcome);
  } catch (...) {
    explain_exception(outcome);
  }
  guard.conclude(request, outcome);
  return outcome;
}

template <Ode P>
State<P> start_of(const Contest<P>& contest) {
  State<P> y = make_state(*contest.problem);
  std::copy(contest.y0->begin(), contest.y0->end(), y.begin());
  return y;
}

/// The problem of initial_step by a type of its own: own methods have that function on P, in units
/// that are compiled by another rule (odeum_timed in CMakeLists.txt).
template <Ode P>
struct Starting : Guarded<P> {
  explicit Starting(const Guarded<P>& problem) : Guarded<P>(problem) {}
};

/// The first step, which odeint leaves to its user, by the rule that own methods follow.
template <Ode P>
double first_step(const Guarded<P>& problem, const Contest<P>& contest, const State<P>& y,
                  int order, const Request& request) {
  return initial_step(Starting<P>(problem), contest.t0, y, request.stops.back(), order,
                      request.tolerance);
}

/// A stepper with do_step(system, y, t, h), in place.
template <class Stepper, Ode P>
Outcome run_plain(const Contest<P>& contest, const Request& request) {
  if (request.mode == Mode::adaptive) return refuse_adaptive();
  return attempt(contest, request, [&](const Guarded<P>& problem, Outcome& outcome) {
    const System<P> system{&problem};
    Stepper stepper;
    State<P> y = start_of(contest);
    walk_fixed(contest.t0, request, y, outcome,
               [&](State<P>& state, double t, double h) { stepper.do_step(system, state, t, h); });
  });
}

template <class Stepper>
using Controlled = boost::numeric::odeint::controlled_runge_kutta<Stepper>;

/// To a tolerance that is the same for all components, see scaled.hpp.
template <class Stepper>
Controlled<Stepper> make_controlled(const Tolerance& tolerance) {
  // The library copies the stepper with its work space: static, so that it is zero and not
  // uninitialised.
  static const Stepper blank;
  using Checker = typename Controlled<Stepper>::error_checker_type;
  using Adjuster = typename Controlled<Stepper>::step_adjuster_type;
  return Controlled<Stepper>(Checker(tolerance.absolute(0), tolerance.relative), Adjuster(), blank);
}

/// Adaptive, by the controlled_runge_kutta that make_controlled returns.
template <class Stepper, Ode P>
Outcome run_to_tolerance(const Contest<P>& contest, const Request& request) {
  return attempt(contest, request, [&](const Guarded<P>& problem, Outcome& outcome) {
    Controlled<Stepper> stepper = make_controlled<Stepper>(request.tolerance);
    State<P> y = start_of(contest);
    walk_controlled(stepper, System<P>{&problem}, contest.t0,
                    first_step(problem, contest, y, Stepper::error_order_value, request), request,
                    y, outcome);
  });
}

/// A stepper with an error estimate; `fixed` runs it at a fixed step.
template <class Stepper, auto fixed, Ode P>
Outcome run_either(const Contest<P>& contest, const Request& request) {
  return request.mode == Mode::fixed ? fixed(contest, request)
                                     : run_to_tolerance<Stepper>(contest, request);
}

/// A stepper called out of place at a fixed step: called in place, extrapolation_stepper overwrites
/// its own input, and so do the multistep steppers while it starts them
/// (reports/findings/odeint.md).
template <class Stepper, Ode P>
Outcome run_out_of_place(const Contest<P>& contest, const Request& request) {
  if (request.mode == Mode::adaptive) return refuse_adaptive();
  return attempt(contest, request, [&](const Guarded<P>& problem, Outcome& outcome) {
    const System<P> system{&problem};
    Stepper stepper;
    State<P> y = start_of(contest), next = y;
    walk_fixed(contest.t0, request, y, outcome, [&](State<P>& state, double t, double h) {
      stepper.do_step(system, state, t, next, h);
      std::swap(state, next);
    });
  });
}

/// A stepper that is itself controlled, made from (absolute, relative) tolerance; `order` is that
/// of its first step.
template <class Controlled, int order, Ode P>
Outcome run_controlled(const Contest<P>& contest, const Request& request) {
  if (request.mode == Mode::fixed) return refuse_fixed();
  return attempt(contest, request, [&](const Guarded<P>& problem, Outcome& outcome) {
    Controlled stepper(request.tolerance.absolute(0), request.tolerance.relative);
    State<P> y = start_of(contest);
    walk_controlled(stepper, System<P>{&problem}, contest.t0,
                    first_step(problem, contest, y, order, request), request, y, outcome);
  });
}

/// A dense-output stepper; make(tolerance) makes it, `order` is that of its first step.
template <auto make, int order, Ode P>
Outcome run_dense(const Contest<P>& contest, const Request& request) {
  if (request.mode == Mode::fixed) return refuse_fixed();
  return attempt(contest, request, [&](const Guarded<P>& problem, Outcome& outcome) {
    auto stepper = make(request.tolerance);
    State<P> y = start_of(contest);
    walk_dense(stepper, System<P>{&problem}, contest.t0,
               first_step(problem, contest, y, order, request), request, y, outcome);
  });
}

/// A stepper with an error estimate for which the library has dense output: between its steps that
/// gives the states at outputs.
template <class Stepper, auto fixed, auto dense, Ode P>
Outcome run_with_outputs(const Contest<P>& contest, const Request& request) {
  return request.mode == Mode::adaptive && request.over_stops
             ? dense(contest, request)
             : run_either<Stepper, fixed>(contest, request);
}

/// A stepper on pairs (q, v), with the kind of system that it takes.
template <class Stepper, template <class> class PairSystem, Ode P>
Outcome run_pair(const Contest<P>& contest, const Request& request) {
  if (request.mode == Mode::adaptive) return refuse_adaptive();
  return attempt(contest, request, [&](const Guarded<P>& problem, Outcome& outcome) {
    PairSystem<P> system{&problem};
    if constexpr (requires { system.step_start; }) system.step_start = &outcome.t;
    Stepper stepper;
    const State<P> y0 = start_of(contest);
    const auto middle = y0.begin() + static_cast<std::ptrdiff_t>(y0.size() / 2);
    std::pair<Half<P>, Half<P>> y;
    if constexpr (P::dimension == dynamic) {
      y = {{y0.begin(), middle}, {middle, y0.end()}};
    } else {
      std::copy(y0.begin(), middle, y.first.begin());
      std::copy(middle, y0.end(), y.second.begin());
    }
    walk_fixed(contest.t0, request, y, outcome,
               [&](auto& state, double t, double h) { stepper.do_step(system, state, t, h); });
  });
}

}  // namespace odeum::adapters::odeint
