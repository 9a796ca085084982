// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/control/switching.hpp"
#include "odeum/methods/dormand_prince54.hpp"
#include "odeum/methods/rodas4.hpp"

namespace odeum::methods {

/// Dormand and Prince's pair 5(4), and RODAS where the problem is stiff. The explicit pair's
/// stability region ends at z = -3.3 on the real axis.
struct dormand_prince54_rodas4 : ForAnyProblem {
  static constexpr MethodInfo info{
      .id = "dormand_prince54_rodas4",
      .family = "switching",
      .order = 0,
      .one_step = false,
      .fixed_step = false,
      .adaptive_order = true,
      .controller = "embedded pairs; which one by the spectral radius of the Jacobian",
      .source = "Petzold, SIAM J. Sci. Stat. Comput. 4 (1983) 136-148; the two methods' own"};

  template <Ode P>
  static auto trial_steps(const P& problem, double t0, const State<P>& y0, double end,
                          const Tolerance& tolerance) {
    using Trial = SwitchingTrial<dormand_prince54, rodas4, P>;
    return TrialSteps<Trial>{initial_step(problem, t0, y0, end, 4, tolerance),
                             Trial(problem, tolerance, 3.3)};
  }
};

}  // namespace odeum::methods
