// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17: shared with the translation unit of the uBLAS steppers.
#include <algorithm>
#include <boost/numeric/odeint/stepper/controlled_step_result.hpp>
#include <utility>

#include "odeint/report.hpp"

/// Loops that run odeint's steppers from stop to stop. Steps are counted one by one, so that an
/// exception from a right-hand side leaves an outcome with the progress made.
namespace odeum::adapters::odeint {

template <class Y>
void record(Outcome& outcome, double t, const Y& y) {
  outcome.record(t, &y[0], y.size());
}
template <class Q, class V>
void record(Outcome& outcome, double t, const std::pair<Q, V>& y) {
  record(outcome, t, y.first);
  record(outcome, t, y.second);
}

template <class Y>
bool finite(const Y& y) {
  return is_finite(&y[0], y.size());
}
template <class Q, class V>
bool finite(const std::pair<Q, V>& y) {
  return finite(y.first) && finite(y.second);
}

/// Makes exactly request.steps calls of step(y, t, h); fewer where the state is no longer finite.
template <class Y, class Step>
void walk_fixed(double t0, const Request& request, Y& y, Outcome& outcome, Step&& step) {
  const FixedGrid grid(t0, request);
  std::uint64_t& i = outcome.counters.steps;
  for (std::size_t stop = 0; stop < grid.stop_count(); ++stop) {
    for (const std::uint64_t end = grid.index_of(stop); i < end; ++i) {
      outcome.t = grid.t(i);
      step(y, outcome.t, grid.h());
      if (grid.checks(i) && !finite(y)) return record(outcome, outcome.t, y);
    }
    record(outcome, request.stops[stop], y);
  }
}

/// Runs a controlled stepper like integrate_adaptive, but with a smallest step, and keeping the
/// step size across a stop. `h` is the first step, which odeint has no rule for.
template <class Controlled, class System, class Y>
void walk_controlled(Controlled& stepper, System system, double t, double h, const Request& request,
                     Y& y, Outcome& outcome) {
  for (const double stop : request.stops) {
    while (t < stop) {
      outcome.t = t;
      if (!step_is_large_enough(h, t, outcome)) return;
      const bool last = t + h >= stop - smallest_step(t, stop);
      double proposed = last ? stop - t : h;
      if (stepper.try_step(system, y, t, proposed) == boost::numeric::odeint::success) {
        ++outcome.counters.steps;
        if (last) t = stop;
        if (request.record_steps) outcome.step_ends.push_back(t);
        h = last ? std::max(h, proposed) : proposed;
      } else {
        ++outcome.counters.rejected_steps;
        h = proposed;
      }
    }
    record(outcome, stop, y);
  }
}

/// Runs a dense-output stepper: stops are interpolated, only the last step is shortened to end at
/// the horizon. It does not report rejected steps.
template <class Dense, class System, class Y>
void walk_dense(Dense& stepper, System system, double t0, double first_step, const Request& request,
                Y& y, Outcome& outcome) {
  const double horizon = request.stops.back();
  stepper.initialize(y, t0, first_step);
  for (const double stop : request.stops) {
    while (stepper.current_time() < stop - smallest_step(t0, stop)) {
      const double t = stepper.current_time(), h = stepper.current_time_step();
      outcome.t = t;
      if (!step_is_large_enough(h, t, outcome)) return;
      if (t + h > horizon) stepper.initialize(Y(stepper.current_state()), t, horizon - t);
      stepper.do_step(system);
      ++outcome.counters.steps;
      if (request.record_steps) outcome.step_ends.push_back(stepper.current_time());
    }
    // The end of a step needs no interpolation.
    if (stepper.current_time() <= stop + smallest_step(t0, stop))
      y = stepper.current_state();
    else
      stepper.calc_state(stop, y);
    record(outcome, stop, y);
  }
}

}  // namespace odeum::adapters::odeint
