// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/control/radau_order.hpp"
#include "odeum/methods/radau_iia5.hpp"
#include "odeum/methods/radau_iia9.hpp"

namespace odeum::methods {

inline constexpr Tableau<7> radau_iia13_tableau = collocation<7>(radau_right_nodes<7>(), 13);
static_assert(collocation_proven(radau_iia13_tableau, 7, 6));

/// Radau IIA of three, five and seven stages: variable step and order (5, 9, 13).
struct radau_iia_variable : ForFewUnknowns {
  static constexpr MethodInfo info{
      .id = "radau_iia_variable",
      .family = "implicit_rk",
      .order = 0,
      .one_step = false,
      .fixed_step = false,
      .adaptive_order = true,
      .controller = "embedded estimate, predictive; order by the contraction of Newton's iteration",
      .source = "Hairer, Wanner, J. Comput. Appl. Math. 111 (1999) 93-111, section 5"};

  template <Ode P>
  static auto trial_steps(const P& problem, double t0, const State<P>& y0, double end,
                          const Tolerance& tolerance) {
    using First = RadauTrial<radau_iia5_tableau, P>;
    using Trial = RadauOrderTrial<P, First, RadauTrial<radau_iia9_tableau, P>,
                                  RadauTrial<radau_iia13_tableau, P>>;
    const Tolerance held = First::held_tolerance(tolerance);
    return TrialSteps<Trial>{initial_step(problem, t0, y0, end, First::order, held),
                             {problem, tolerance}};
  }
};

}  // namespace odeum::methods
