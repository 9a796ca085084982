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
  static constexpr bool leaves_out_ends = true;
  static constexpr MethodInfo info{
      .id = "seulex",
      .family = "extrapolation",
      .order = fixed_column,
      .adaptive_order = true,
      .controller = "step and column, by work per unit step",
      .source = "Deuflhard, Hairer, Zugck, Numer. Math. 51 (1987) 501-516; Solving ODEs II, IV.9"};
  static constexpr auto inlined = Inlined::stiff;
  template <class P>
  using Stepper = ExtrapolatedEuler<fixed_column, P>;

  template <Ode P>
  static auto trial_steps(const P& problem, double t0, const State<P>& y0, double end,
                          const Tolerance& tolerance) {
    return TrialSteps<ExtrapolatedEulerControl<P>>{initial_step(problem, t0, y0, end, 2, tolerance),
                                                   {problem, tolerance}};
  }

  static double rounding() { return extrapolated_euler_rounding<fixed_column>(); }
  static double amplification(double re, double im) {
    return extrapolated_euler_amplification<fixed_column>({re, im});
  }
};

}  // namespace odeum::methods
