// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/control/bdf_control.hpp"
#include "odeum/kernel/method.hpp"

namespace odeum::methods {

/// Numerical differentiation formulas of variable step and variable order (1 to 5): a smaller error
/// constant than BDF at nearly the same stability.
struct bdf_variable : ForAnyProblem {
  static constexpr MethodInfo info{
      .id = "bdf_variable",
      .family = "multistep",
      .order = 0,
      .one_step = false,
      .fixed_step = false,
      .adaptive_order = true,
      .controller = "step and order, from backward differences",
      .source = "Shampine, Reichelt, SIAM J. Sci. Comput. 18 (1997) 1-22, section 2"};
  static constexpr auto inlined = Inlined::stiff;
  template <Ode P>
  static auto trial_steps(const P& problem, double t0, const State<P>& y0, double end,
                          const Tolerance& requested) {
    // Local errors of many small steps of low order accumulate: the local tolerance is a fraction
    // of the one requested, so that the error at the end meets it.
    const Tolerance tolerance = requested.with_relative(requested.relative / 20);
    const double first = initial_step(problem, t0, y0, end, 1, tolerance);
    return TrialSteps<BdfTrial<P>>{first, {problem, t0, y0, first, tolerance}};
  }
};

}  // namespace odeum::methods
