// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/judge/order_fit.hpp"
#include "odeum/proof/any_stepper.hpp"
#include "odeum/proof/test_problems.hpp"

namespace odeum::proof {

/// The order measured on a test problem, with a verdict as in `odeum converge`: the largest error
/// over four stops against the step, fitted over the asymptotic window. `rounding`: of one step
/// over that of the state.
judge::OrderFit measure_order(AnyStepper& stepper, double claimed_order, double t0, double horizon,
                              const std::vector<double>& y0,
                              const std::function<void(double t, double* y)>& truth,
                              double rounding);

template <class P>
judge::OrderFit measure_order(const MakeStepper<P>& make, double claimed_order,
                              const TestProblem<P>& test, double rounding = 1) {
  const auto stepper = make(test.problem);
  return measure_order(*stepper, claimed_order, test.t0, test.horizon, test.y0, test.truth,
                       rounding);
}

}  // namespace odeum::proof
