// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// Euler's equations y1' = a y2 y3, y2' = b y3 y1, y3' = c y1 y2.
struct RigidBody {
  static constexpr std::size_t dimension = 3;
  double a, b, c;

  template <class R>
  void rhs(R, const R* y, R* f) const {
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

Case make_free(const Values& values) {
  const double i1 = values[0], i2 = values[1], i3 = values[2];
  for (const double inertia : {i1, i2, i3}) require_positive("moment of inertia", inertia);
  Case c = describe("rigid_body_hlw", "rigid_body_hlw", "Free rigid body", 1.5e-16);
  c.equation = "y1' = (1/I3 - 1/I2) y2 y3 and cyclic, y(0) = (cos angle, 0, sin angle)";
  c.source = "Hairer, Lubich, Wanner, Geometric Numerical Integration, (IV.1.4), VII.5";
  c.y0 = {std::cos(values[3]), 0, std::sin(values[3])};
  c.invariants = {
      {"momentum_squared", [](const double* y) { return y[0] * y[0] + y[1] * y[1] + y[2] * y[2]; }},
      {"twice_energy",
       [=](const double* y) { return y[0] * y[0] / i1 + y[1] * y[1] / i2 + y[2] * y[2] / i3; }}};
  set_stage(c, RigidBody{1 / i3 - 1 / i2, 1 / i1 - 1 / i3, 1 / i2 - 1 / i1});
  return c;
}

Case make_elliptic(const Values& values) {
  const double m = values[0];
  Case c =
      describe("rigid_body_detest_b5", "rigid_body_detestB5", "Jacobi's elliptic functions", 5e-17);
  c.equation = "y1' = y2 y3, y2' = -y1 y3, y3' = -m y1 y2, y(0) = (0, 1, 1)";
  c.source = "Hull, Enright, Fellen, Sedgwick, SIAM J. Numer. Anal. 9 (1972), problem B5";
  c.y0 = {0, 1, 1};
  c.invariants = {{"sn2_cn2", [](const double* y) { return y[0] * y[0] + y[1] * y[1]; }},
                  {"m_sn2_dn2", [m](const double* y) { return m * y[0] * y[0] + y[2] * y[2]; }}};
  set_stage(c, RigidBody{1, -1, -m});
  return c;
}

}  // namespace

/// Euler's equations of two free rigid bodies.
std::vector<Case> rigid_body() {
  return {with_tabled_parameters({{"I1", 2, "moment of inertia"},
                                  {"I2", 1, "moment of inertia"},
                                  {"I3", 2.0 / 3, "moment of inertia"},
                                  {"angle", 1.1, "of the momentum to the first axis, rad"}},
                                 make_free),
          with_tabled_parameters({{"m", 0.51, "of the elliptic functions"}}, make_elliptic)};
}

}  // namespace odeum::cases
