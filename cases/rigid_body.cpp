// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// Euler's equations y1' = a y2 y3, y2' = b y3 y1, y3' = c y1 y2.
struct RigidBody {
  static constexpr std::size_t dimension = 3;
  double a, b, c;

  void rhs(double, const double* y, double* f) const {
    f[0] = a * y[1] * y[2];
    f[1] = b * y[2] * y[0];
    f[2] = c * y[0] * y[1];
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = j[4] = j[8] = 0;
    j[1] = a * y[2];
    j[2] = a * y[1];
    j[3] = b * y[2];
    j[5] = b * y[0];
    j[6] = c * y[1];
    j[7] = c * y[0];
  }
};

Case describe(const char* id, const char* reference, const char* title, double floor) {
  Case c;
  c.id = id;
  c.title = title;
  c.tags = {"nonlinear", "autonomous", "mechanical"};
  c.stops = {1, 5, 10};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 40;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth(reference, floor);
  return c;
}

}  // namespace

/// Euler's equations of two free rigid bodies.
std::vector<Case> rigid_body() {
  constexpr double i1 = 2, i2 = 1, i3 = 2.0 / 3;
  Case free = describe("rigid_body_hlw", "rigid_body_hlw", "Free rigid body", 1.5e-16);
  free.equation = "y1' = (1/I3 - 1/I2) y2 y3 and cyclic, I = (2, 1, 2/3)";
  free.source = "Hairer, Lubich, Wanner, Geometric Numerical Integration, (IV.1.4), VII.5";
  free.y0 = {std::cos(1.1), 0, std::sin(1.1)};
  free.invariants = {
      {"momentum_squared", [](const double* y) { return y[0] * y[0] + y[1] * y[1] + y[2] * y[2]; }},
      {"twice_energy",
       [](const double* y) { return y[0] * y[0] / i1 + y[1] * y[1] / i2 + y[2] * y[2] / i3; }}};
  set_stage(free, RigidBody{1 / i3 - 1 / i2, 1 / i1 - 1 / i3, 1 / i2 - 1 / i1});

  Case detest =
      describe("rigid_body_detest_b5", "rigid_body_detestB5", "Jacobi's elliptic functions", 5e-17);
  detest.equation = "y1' = y2 y3, y2' = -y1 y3, y3' = -0.51 y1 y2, y(0) = (0, 1, 1)";
  detest.source = "Hull, Enright, Fellen, Sedgwick, SIAM J. Numer. Anal. 9 (1972), problem B5";
  detest.y0 = {0, 1, 1};
  detest.invariants = {
      {"sn2_cn2", [](const double* y) { return y[0] * y[0] + y[1] * y[1]; }},
      {"m_sn2_dn2", [](const double* y) { return 0.51 * y[0] * y[0] + y[2] * y[2]; }}};
  set_stage(detest, RigidBody{1, -1, -0.51});
  return {free, detest};
}

}  // namespace odeum::cases
