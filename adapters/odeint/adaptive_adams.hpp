// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <boost/numeric/odeint/stepper/adaptive_adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/controlled_adams_bashforth_moulton.hpp>
#include <boost/numeric/odeint/stepper/extrapolation_stepper.hpp>

#include "odeint/run.hpp"

/// The Adams steppers of variable coefficients, which need their own creation and start.
namespace odeum::adapters::odeint {

/// At a fixed step. A stepper that starts itself begins at order 1 and never exceeds order 3; so
/// the first step is made by initialize(), as K sub-steps of a one-step method of order K + 2, the
/// order that initialize() can use.
template <std::size_t K, Ode P>
Outcome run_adaptive_adams(const Contest<P>& contest, const Request& request) {
  static_assert(K % 2 == 0, "extrapolation_stepper has even orders only");
  if (request.mode == Mode::adaptive) return refuse_adaptive();
  return attempt(contest, request, [&](const Guarded<P>& problem, Outcome& outcome) {
    const System<P> system{&problem};
    using Y = State<P>;
    boost::numeric::odeint::adaptive_adams_bashforth_moulton<K, Y> stepper;
    bool started = false;
    Y y = start_of(contest);
    walk_fixed(contest.t0, request, y, outcome, [&](Y& state, double t, double h) {
      if (started) {
        stepper.do_step(system, state, t, h);
      } else {
        // initialize() copies it: static, so that its work space is zero and not uninitialised.
        static const boost::numeric::odeint::extrapolation_stepper<K + 2, Y> starter;
        stepper.initialize(starter, system, state, t, h);
        started = true;
      }
    });
  });
}

/// Adaptive, at orders up to K.
template <std::size_t K, Ode P>
Outcome run_controlled_adams(const Contest<P>& contest, const Request& request) {
  if (request.mode == Mode::fixed) return refuse_fixed();
  return attempt(contest, request, [&](const Guarded<P>& problem, Outcome& outcome) {
    using Y = State<P>;
    using Stepper = boost::numeric::odeint::controlled_adams_bashforth_moulton<
        boost::numeric::odeint::adaptive_adams_bashforth_moulton<K, Y>>;
    // The default largest step is 1, a bound that no problem requested.
    Stepper stepper(typename Stepper::step_adjuster_type(request.tolerance.absolute(0),
                                                         request.tolerance.relative,
                                                         request.stops.back() - contest.t0));
    Y y = start_of(contest);
    walk_controlled(stepper, System<P>{&problem}, contest.t0,
                    first_step(problem, contest, y, 1, request), request, y, outcome);
  });
}

}  // namespace odeum::adapters::odeint
