// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include "odeum/core/guarded.hpp"
#include "odeum/core/outcome.hpp"

namespace odeum {

/// Runs a stepper over t_i = t0 + i h, recording the state at every stop; refused where a stop is
/// not on that grid.
template <class Stepper, Ode P>
Outcome run_fixed(const Guarded<P>& problem, double t0, const State<P>& y0,
                  const Request& request) {
  Outcome outcome;
  const FixedGrid grid(t0, request);
  if (!grid.fits()) {
    outcome.status = Status::refused;
    outcome.detail = fmt::format("a stop is not on the grid of steps of {}", grid.h());
    outcome.t = t0;
    return outcome;
  }
  Stepper stepper(problem);
  State<P> y = y0;
  if constexpr (requires { stepper.start(t0, grid.h(), y); }) stepper.start(t0, grid.h(), y);
  std::uint64_t i = 0;
  for (std::size_t stop = 0; stop < grid.stop_count(); ++stop) {
    for (const std::uint64_t end = grid.index_of(stop); i < end; ++i) {
      outcome.status = stepper.step(grid.t(i), grid.h(), y);
      if (outcome.status != Status::ok || problem.tripped()) {
        outcome.t = grid.t(i);
        if (outcome.status != Status::ok)
          outcome.detail = fmt::format("{} at t = {}", to_string(outcome.status), outcome.t);
        outcome.counters.steps = i;
        return outcome;
      }
    }
    outcome.record(request.stops[stop], y.data(), y.size());
  }
  outcome.counters.steps = i;
  return outcome;
}

}  // namespace odeum
