// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

constexpr double g = 9.81;  // m/s^2

/// y'' = g - k y'^2, y downwards.
struct Drag {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = true;
  static constexpr double k = 0.01;

  void acceleration(double, const double*, const double* v, double* a) const {
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

  void acceleration(double, const double*, const double*, double* a) const {
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

}  // namespace

/// Fall with quadratic drag, and a projectile without drag.
std::vector<Case> ballistics() {
  Case drag;
  drag.id = "freefall_drag";
  drag.title = "Fall with drag";
  drag.equation = "y'' = 9.81 - 0.01 y'^2, y(0) = y'(0) = 0";
  drag.source = "quadratic drag, any mechanics text";
  drag.tags = {"nonlinear", "autonomous", "second_order", "mechanical"};
  drag.y0 = {0, 0};
  drag.stops = {1, 5, 10};
  drag.settings.steps_multiple = 10;
  drag.settings.coarsest_steps = 20;
  drag.settings.finest_steps = 2560;
  drag.settings.evaluation_budget = 30'000;
  drag.truth = reference_truth("freefall_drag", 6.1e-15);
  set_stage(drag, Drag{});

  Case projectile;
  projectile.id = "projectile";
  projectile.title = "Projectile";
  projectile.equation = "x'' = 0, y'' = -9.81, from (0, 0) at (30, 40) m/s";
  projectile.source = "Galilei 1638";
  projectile.tags = {"linear", "autonomous", "second_order", "separable", "mechanical"};
  projectile.y0 = {0, 0, 30, 40};
  projectile.stops = {1, 2, 4};
  projectile.settings.steps_multiple = 4;
  projectile.settings.coarsest_steps = 8;
  projectile.settings.finest_steps = 1024;
  projectile.settings.evaluation_budget = 30'000;
  projectile.truth = reference_truth("projectile", 1.5e-14);  // 9.81 is not a double
  projectile.invariants = {{"momentum_x", [](const double* y) { return y[2]; }}};
  set_stage(projectile, Projectile{});
  return {drag, projectile};
}

}  // namespace odeum::cases
