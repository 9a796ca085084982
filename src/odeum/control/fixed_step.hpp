// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <utility>

#include "odeum/control/adaptive.hpp"
#include "odeum/core/outcome.hpp"
#include "odeum/core/request.hpp"
#include "odeum/core/text_of.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Runs a stepper over t_i = t0 + i h, recording the state at every stop; refused where a stop is
/// not on that grid. A state that is not finite ends the run. A stepper that tells where its steps
/// are too long for what grows (`oversteps_growth`) has the first such time in `detail` of
/// a run that ends `ok`.
template <class Stepper, Ode P>
Outcome run_fixed(const P& problem, double t0, const State<P>& y0, const Request& request) {
  Outcome outcome;
  const FixedGrid grid(t0, request);
  std::uint64_t i = 0;
  const auto stopped = [&](Status status, std::string why) {
    outcome.status = status;
    outcome.detail = std::move(why);
    outcome.t = grid.t(i);
    outcome.counters.steps = i;
    return outcome;
  };
  if (!grid.fits())
    return stopped(Status::refused, "a stop is not on the grid of steps of " + text_of(grid.h()));
  Stepper stepper(problem);
  State<P> y = y0;
  std::string remark;
  if constexpr (requires { stepper.start(t0, grid.h(), y); }) stepper.start(t0, grid.h(), y);
  for (std::size_t stop = 0; stop < grid.stop_count(); ++stop) {
    for (const std::uint64_t end = grid.index_of(stop); i < end; ++i) {
      const Status status = stepper.step(grid.t(i), grid.h(), y);
      // A step from a state that is not finite may fail in its own way before the next check.
      const bool check = grid.checks(i) || i + 1 == end || status != Status::ok;
      if (check && !is_finite(y.data(), y.size()))
        return stopped(Status::non_finite,
                       "the state is not finite after t = " + text_of(grid.t(i)));
      if (status != Status::ok || problem.tripped())
        return stopped(status, to_string(status) + (" at t = " + text_of(grid.t(i))));
      if constexpr (WithProjection<P>)
        if (offers_project(problem) && problem.project(grid.t(i + 1), y.data()) == 0)
          return not_projected(outcome, grid.t(i + 1));
      if constexpr (requires { stepper.oversteps_growth(); })
        if (remark.empty() && stepper.oversteps_growth())
          remark =
              "from t = " + text_of(grid.t(i)) +
              " on a step is too long for what grows: det(I - gamma h J) < 0, where the method "
              "may step over the end of a solution";
    }
    outcome.record(request.stops[stop], y.data(), y.size());
  }
  outcome.counters.steps = i;
  outcome.detail = std::move(remark);
  return outcome;
}

}  // namespace odeum
