// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/model/scene.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// x' = v, v' = g.
struct FreeFall {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = false;
  static constexpr double g = -9.81;  // m/s^2

  void acceleration(double, const double*, const double*, double* a) const { a[0] = g; }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
  void jacobian(double, const double*, double* j) const {
    j[0] = 0;
    j[1] = 1;
    j[2] = j[3] = 0;
  }
  void linear_matrix(double* a) const { jacobian(0, nullptr, a); }
  /// Per unit mass, J/kg.
  double energy(const double* y) const { return y[1] * y[1] / 2 - g * y[0]; }
};

}  // namespace

/// A body thrown upwards. The numerical solutions have closed forms too, which tests use.
std::vector<Case> free_fall() {
  Case c;
  c.id = "free_fall";
  c.title = "Free fall";
  c.equation = "x' = v, v' = -9.81, x(0) = 10, v(0) = 3";
  c.source = "Galilei 1638";
  c.tags = {"linear", "autonomous", "second_order", "separable", "mechanical", "smooth"};
  c.y0 = {10, 3};
  c.stops = {0.5, 1, 1.5, 2};
  c.settings.steps_multiple = 4;
  c.settings.coarsest_steps = 8;
  c.settings.finest_steps = 8192;
  c.truth.source = "closed form";
  c.truth.at = [](double t, double* y) {
    y[0] = 10 + t * (3 + t * FreeFall::g / 2);
    y[1] = 3 + t * FreeFall::g;
    return true;
  };
  auto scene = std::make_shared<scene::Scene>();
  scene->particles = {{.position = {10, 0, 0}, .velocity = {3, 0, 0}, .mass = 1}};
  scene->gravity = {FreeFall::g, 0, 0};
  scene->select = {0, 3};
  set_stage(c, FreeFall{}, scene);
  return {c};
}

}  // namespace odeum::cases
