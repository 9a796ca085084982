// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/control/extrapolation_control.hpp"
#include "odeum/core/outcome.hpp"
#include "odeum/kernel/extrapolation.hpp"
#include "odeum/kernel/method.hpp"

namespace odeum::methods {

/// Gragg, Bulirsch and Stoer: the modified midpoint rule in 2, 4, 6, ... substeps, extrapolated to
/// substep zero. At a fixed step four lines of the table, order 8, 21 evaluations per step;
/// adaptive runs choose the number of lines and the step.
struct gragg_bulirsch_stoer : ForAnyProblem {
  static constexpr int fixed_lines = 4;
  static constexpr MethodInfo info{
      .id = "gragg_bulirsch_stoer",
      .family = "extrapolation",
      .order = 2 * fixed_lines,
      .adaptive_order = true,
      .controller = "order and step by least work",
      .source =
          "Bulirsch, Stoer, Numer. Math. 8 (1966) 1-13; Hairer, Norsett, Wanner, Solving "
          "ODEs I, II.9, (9.10), (9.13)"};
  static constexpr auto inlined = Inlined::nonstiff;

  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem) : table_(problem) {}

    Status step(double t, double h, State<P>& y) {
      table_.begin(t, h, y, fixed_lines);
      for (int line = 0; line < fixed_lines; ++line) table_.add_line(line);
      table_.result(fixed_lines - 1, y);
      return Status::ok;
    }

   private:
    ExtrapolationTable<P, fixed_lines> table_;
  };

  template <class P>
  static auto trial_steps(const P& problem, double t0, const State<P>& y0, double end,
                          const Tolerance& tolerance) {
    ExtrapolationTrial<P> trial(problem, tolerance);
    const double first = initial_step(problem, t0, y0, end, trial.order(), tolerance);
    return TrialSteps{first, std::move(trial)};
  }

  static double amplification(double re, double im) {
    return std::abs(extrapolated_midpoint_stability<fixed_lines>({re, im}));
  }
};

}  // namespace odeum::methods
