// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// y'' = g - k y'^2, y downwards.
struct Drag {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = true;
  double g = 9.81, k = 0.01;

  template <class R>
  void acceleration(R, const R*, const R* v, R* a) const {
    a[0] = g - k * v[0] * v[0];
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = j[2] = 0;
    j[1] = 1;
    j[3] = -2 * k * y[1];
  }
};

/// x'' = 0, y'' = -g.
struct Projectile {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = false;
  double g = 9.81;  // m/s^2

  template <class R>
  void acceleration(R, const R*, const R*, R* a) const {
    a[0] = 0;
    a[1] = -g;
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 2, t, y, dydt);
  }
  void jacobian(double, const double*, double* j) const {
    for (int i = 0; i < 16; ++i) j[i] = 0;
    j[2] = j[7] = 1;
  }
  void linear_matrix(double* a) const { jacobian(0, nullptr, a); }
  /// Per unit mass, J/kg.
  double energy(const double* y) const { return (y[2] * y[2] + y[3] * y[3]) / 2 + g * y[1]; }
};

Case make_drag(const Values& values) {
  Case c;
  c.id = "freefall_drag";
  c.title = "Fall with drag";
  c.equation = "y'' = g - k y'^2, y(0) = 0, y'(0) = v0";
  c.source = "quadratic drag, any mechanics text";
  c.tags = {"nonlinear", "autonomous", "second_order", "mechanical"};
  c.y0 = {0, values[2]};
  c.components = {"y", "v"};
  c.stops = {1, 5, 10};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 20;
  c.settings.finest_steps = 2560;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth("freefall_drag", 6.1e-15);
  set_stage(c, Drag{values[0], values[1]});
  return c;
}

Case make_projectile(const Values& values) {
  Case c;
  c.id = "projectile";
  c.title = "Projectile";
  c.equation = "x'' = 0, y'' = -g, from (0, 0) at (vx, vy)";
  c.source = "Galilei 1638";
  c.tags = {"linear", "autonomous", "second_order", "separable", "mechanical"};
  c.y0 = {0, 0, values[1], values[2]};
  c.components = {"x", "y", "vx", "vy"};
  c.stops = {1, 2, 4};
  c.settings.steps_multiple = 4;
  c.settings.coarsest_steps = 8;
  c.settings.finest_steps = 1024;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth("projectile", 1.5e-14);  // 9.81 is not a double
  c.invariants = {{"momentum_x", [](const double* y) { return y[2]; }}};
  set_stage(c, Projectile{values[0]});
  return c;
}

}  // namespace

/// Fall with quadratic drag, and a projectile without drag.
std::vector<Case> ballistics() {
  const Parameter g{"g", 9.81, "gravity, m/s^2"};
  return {
      with_tabled_parameters({g,
                              {"k", 0.01, "drag over mass, 1/m"},
                              {"v0", 0, "velocity at the start, downwards, m/s"}},
                             make_drag),
      with_tabled_parameters(
          {g, {"vx", 30, "velocity at the start, m/s"}, {"vy", 40, "velocity at the start, m/s"}},
          make_projectile)};
}

}  // namespace odeum::cases
