// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/judge/order_fit.hpp"
#include "odeum/proof/any_stepper.hpp"
#include "odeum/proof/grounds.hpp"

namespace odeum::proof {

/// The order measured on a test problem, with a verdict as in `odeum converge`: the largest error
/// over four stops against the step, fitted over the asymptotic window.
judge::OrderFit measure_order(AnyStepper& stepper, double claimed_order, double t0, double horizon,
                              const std::vector<double>& y0,
                              const std::function<void(double t, double* y)>& truth);

template <class P>
judge::OrderFit measure_order(const MakeStepper<P>& make, double claimed_order,
                              const Ground<P>& ground) {
  const auto stepper = make(ground.problem);
  return measure_order(*stepper, claimed_order, ground.t0, ground.horizon, ground.y0, ground.truth);
}

}  // namespace odeum::proof
