// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// tau V' = A sin(w t) - V.
struct RcCircuit {
  static constexpr std::size_t dimension = 1;
  double tau = 1e-3, amplitude = 5, w = 100 * std::numbers::pi;

  template <class R>
  void rhs(R t, const R* y, R* dydt) const {
    dydt[0] = (amplitude * std::sin(w * t) - y[0]) / tau;
  }
  void jacobian(double, const double*, double* j) const { j[0] = -1 / tau; }
  void time_derivative(double t, const double*, double* dfdt) const {
    dfdt[0] = amplitude * w * std::cos(w * t) / tau;
  }
};

double exact(const RcCircuit& p, double start, double t) {
  const double lag = p.w * p.tau, decay = std::exp(-t / p.tau);
  return p.amplitude / (1 + lag * lag) *
             (std::sin(p.w * t) - lag * std::cos(p.w * t) + lag * decay) +
         start * decay;
}

Case make_case(const Values& values) {
  const RcCircuit problem{values[0], values[1], 2 * std::numbers::pi * values[2]};
  require_positive("tau", problem.tau);
  Case c;
  c.id = "rc_circuit";
  c.title = "RC circuit with a sine source";
  c.equation = "0.001 V' = 5 sin(100 pi t) - V, V(0) = 0";
  c.source = "first-order low-pass filter, any circuits text";
  c.tags = {"linear", "non_autonomous", "smooth"};
  c.y0 = {values[3]};
  c.components = {"V"};
  c.stops = {0.005, 0.02};
  c.settings.steps_multiple = 4;
  c.settings.coarsest_steps = 20;
  c.settings.finest_steps = 20480;
  const auto closed_form = [problem, start = values[3]](double t, double* y) {
    y[0] = exact(problem, start, t);
    return true;
  };
  if (values == Values{1e-3, 5, 50, 0}) {
    c.truth = reference_truth("rc_sine", 7.5e-16);
    c.truth.at = [table = c.truth.at, closed_form](double t, double* y) {
      return table(t, y) || closed_form(t, y);
    };
  } else {
    c.equation = fmt::format("{} V' = {} sin(2 pi {} t) - V, V(0) = {}", problem.tau,
                             problem.amplitude, values[2], values[3]);
    c.truth.source = "closed form";
    c.truth.at = closed_form;
  }
  set_stage(c, problem);
  return c;
}

}  // namespace

/// A capacitor charged through a resistor by a sine source of 50 Hz, over one period.
/// Non-autonomous, so that a wrong node or a missing time derivative shows.
std::vector<Case> rc_circuit() {
  return {with_parameters({{"tau", 1e-3, "R C, s"},
                           {"amplitude", 5, "of the source, V"},
                           {"frequency", 50, "of the source, Hz"},
                           {"V0", 0, "voltage at the start, V"}},
                          make_case)};
}

}  // namespace odeum::cases
