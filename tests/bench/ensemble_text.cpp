// SPDX-License-Identifier: BSD-3-Clause
// A problem as text: members of a sweep in lanes against one after the other, what both need to set
// a member's parameters included.
#include <fmt/format.h>

#include "goals.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/sweep/runner.hpp"

namespace odeum::bench {

Row text_row(const char* solver, double tolerance, double goal) {
  const Case c = cases::text_statements("lorenz.yaml", R"(
parameters: {s: 10, r: 28, b: 8/3}
states: {x: 1, y: 0, z: 0}
equations:
  x: s*(y - x)
  y: x*(r - z) - y
  z: x*y - b*z
time: {end: 5}
)",
                                        "lorenz_text")
                     .front()
                     .make();
  sweep::Plan plan(c, sweep::Members({sweep::axis_of("r~uniform(20,30)")}, 2048, 1));
  plan.solver = std::string("odeum/") + solver;
  plan.request.stops = {5};
  plan.request.steps = 1000;
  if (tolerance > 0) plan.request.mode = Mode::adaptive;
  plan.request.tolerance = tolerance;
  sweep::Runner runner(plan, c.family({}));
  double steps = 0;
  const auto in_lanes = [&] {
    steps = 0;
    for (const Outcome& outcome : runner.run_in_lanes(0, plan.members.size()))
      steps += static_cast<double>(outcome.counters.steps + outcome.counters.rejected_steps);
  };
  const auto one_by_one = [&] {
    for (std::uint64_t k = 0; k < plan.members.size(); ++k)
      runner.run(sweep::parameters_of(plan, k), plan.request);
  };
  const std::vector<Timing> t = interleave({in_lanes, one_by_one}, 0.7);
  return compare(fmt::format("Lorenz as text, {}", solver), goal, t[0], t[1],
                 fmt::format("{:.2f} ns a step and member, alone {:.1f}", 1e9 * t[0].min / steps,
                             1e9 * t[1].min / steps));
}

}  // namespace odeum::bench
