// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// tau V' = A sin(w t) - V.
struct RcCircuit {
  static constexpr std::size_t dimension = 1;
  static constexpr double tau = 1e-3, amplitude = 5, w = 100 * std::numbers::pi;

  void rhs(double t, const double* y, double* dydt) const {
    dydt[0] = (amplitude * std::sin(w * t) - y[0]) / tau;
  }
  void jacobian(double, const double*, double* j) const { j[0] = -1 / tau; }
  void time_derivative(double t, const double*, double* dfdt) const {
    dfdt[0] = amplitude * w * std::cos(w * t) / tau;
  }
};

}  // namespace

/// A capacitor charged through a resistor by a sine source of 50 Hz, over one period.
/// Non-autonomous, so that a wrong node or a missing time derivative shows.
std::vector<Case> rc_circuit() {
  Case c;
  c.id = "rc_circuit";
  c.title = "RC circuit with a sine source";
  c.equation = "0.001 V' = 5 sin(100 pi t) - V, V(0) = 0";
  c.source = "first-order low-pass filter, any circuits text";
  c.tags = {"linear", "non_autonomous", "smooth"};
  c.y0 = {0};
  c.stops = {0.005, 0.02};
  c.settings.steps_multiple = 4;
  c.settings.coarsest_steps = 20;
  c.settings.finest_steps = 20480;
  c.truth = reference_truth("rc_sine", 7.5e-16);
  set_stage(c, RcCircuit{});
  return {c};
}

}  // namespace odeum::cases
