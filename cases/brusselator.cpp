// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// u' = A + u^2 v - (B + 1) u,  v' = B u - u^2 v,  A = 1, B = 3.
struct Brusselator {
  static constexpr std::size_t dimension = 2;

  void rhs(double, const double* y, double* f) const {
    const double autocatalysis = y[0] * y[0] * y[1];
    f[0] = 1 + autocatalysis - 4 * y[0];
    f[1] = 3 * y[0] - autocatalysis;
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = 2 * y[0] * y[1] - 4;
    j[1] = y[0] * y[0];
    j[2] = 3 - 2 * y[0] * y[1];
    j[3] = -y[0] * y[0];
  }
};

}  // namespace

/// A chemical oscillator with an attracting limit cycle.
std::vector<Case> brusselator() {
  Case c;
  c.id = "brusselator2";
  c.title = "Brusselator";
  c.equation = "u' = 1 + u^2 v - 4 u, v' = 3 u - u^2 v, u(0) = 1.5, v(0) = 3";
  c.source = "Lefever, Nicolis 1971; Hairer, Norsett, Wanner, Solving ODEs I, (I.16.12), (II.4.15)";
  c.tags = {"nonlinear", "autonomous", "oscillatory", "chemistry"};
  c.y0 = {1.5, 3};
  c.stops = {1, 5, 10, 20};
  c.settings.steps_multiple = 20;
  c.settings.coarsest_steps = 160;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth("brusselator2", 1e-25);
  set_stage(c, Brusselator{});
  return {c};
}

}  // namespace odeum::cases
