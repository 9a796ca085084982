// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/scene/model/scene.hpp"

namespace odeum::cases {
namespace {

/// x' = v, v' = g.
struct FreeFall {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = false;
  double g = -9.81;  // m/s^2

  template <class R>
  void acceleration(R, const R*, const R*, R* a) const {
    a[0] = g;
  }
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

// What n steps of h give: x0 + n h v0 + factor(n) h^2 g, by solving the scheme's recurrence. The
// factor is n (n - 1) / 2 where a step moves the body by the velocity at its start, n (n + 1) / 2
// by that at its end, n^2 / 2 (exact) by their mean.
bool scheme_of_fall(const FreeFall& fall, double x0, double v0, const std::string& solver, double h,
                    double n, double* y) {
  double factor = n * n / 2;
  if (solver == "odeum/explicit_euler" || solver == "odeum/symplectic_euler_position_first")
    factor = n * (n - 1) / 2;
  else if (solver == "odeum/implicit_euler" || solver == "odeum/symplectic_euler" ||
           solver == "odeum/implicit_euler_linearised")
    factor = n * (n + 1) / 2;
  else if (solver != "odeum/midpoint" && solver != "odeum/heun" && solver != "odeum/rk4" &&
           solver != "odeum/velocity_verlet" && solver != "odeum/trapezoidal" &&
           solver != "odeum/implicit_midpoint")
    return false;
  y[0] = x0 + n * h * v0 + factor * h * h * fall.g;
  y[1] = v0 + n * h * fall.g;
  return true;
}

Case make_case(const Values& values) {
  const FreeFall fall{.g = values[0]};
  const double x0 = values[1], v0 = values[2];
  Case c;
  c.nature.linear = c.nature.smooth = true;
  c.equation = fmt::format("x' = v, v' = {}, x(0) = {}, v(0) = {}", fall.g, x0, v0);
  c.source = "Galilei 1638";
  c.y0 = {x0, v0};
  c.components = {"x", "v"};
  c.stops = {0.5, 1, 1.5, 2};
  c.settings.steps_multiple = 4;
  c.settings.coarsest_steps = 8;
  c.settings.finest_steps = 8192;
  c.truth.source = "closed form";
  c.truth.closed_form = true;
  c.truth.at = [fall, x0, v0](double t, double* y) {
    y[0] = x0 + t * (v0 + t * fall.g / 2);
    y[1] = v0 + t * fall.g;
    return true;
  };
  c.scheme = [fall, x0, v0](const std::string& solver, double h, double steps, double* y) {
    return scheme_of_fall(fall, x0, v0, solver, h, steps, y);
  };
  auto scene = std::make_shared<scene::Scene>();
  scene->particles = {{.position = {x0, 0, 0}, .velocity = {v0, 0, 0}, .mass = 1}};
  scene->gravity = {fall.g, 0, 0};
  scene->select = {0, 3};
  set_problem(c, fall, scene);
  return c;
}

}  // namespace

/// A body thrown upwards. The numerical solutions have closed forms too, which tests use.
std::vector<Statement> free_fall() {
  return {{.id = "free_fall",
           .title = "Free fall",
           .tags = {"second_order", "separable", "mechanical"},
           .make = [] {
             return with_parameters({{"g", -9.81, "acceleration, m/s^2"},
                                     {"x0", 10, "position at the start, m"},
                                     {"v0", 3, "velocity at the start, m/s"}},
                                    make_case);
           }}};
}

}  // namespace odeum::cases
