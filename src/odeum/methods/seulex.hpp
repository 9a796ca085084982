// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/control/extrapolated_euler_control.hpp"
#include "odeum/kernel/extrapolated_euler.hpp"
#include "odeum/kernel/method.hpp"

namespace odeum::methods {

/// Extrapolated linearly implicit Euler: at a fixed step column 5 of the table, order 5; adaptive
/// runs choose column and step.
struct seulex : ForAnyProblem {
  static constexpr std::size_t fixed_column = 5;
  static constexpr MethodInfo info{
      .id = "seulex",
      .family = "extrapolation",
      .order = fixed_column,
      .adaptive_order = true,
      .controller = "step and column, by work per unit step",
      .source = "Deuflhard, Hairer, Zugck, Numer. Math. 51 (1987) 501-516; Solving ODEs II, IV.9"};
  static constexpr bool inlined = true;
  template <class P>
  using Stepper = ExtrapolatedEuler<fixed_column, P>;

  template <Ode P>
  static Outcome integrate(const Guarded<P>& problem, double t0, const State<P>& y0,
                           const Request& request) {
    const double first = initial_step(problem, t0, y0, request.stops.back(), 2, request.tolerance);
    return run_adaptive(problem, t0, y0, request, first,
                        ExtrapolatedEulerControl<Guarded<P>>(problem, request.tolerance));
  }

  static double amplification(double re, double im) {
    return extrapolated_euler_amplification<fixed_column>({re, im});
  }
};

}  // namespace odeum::methods
