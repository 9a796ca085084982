// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// theta'' = -sin theta.
struct Pendulum {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = false;

  template <class R>
  void acceleration(R, const R* q, const R*, R* a) const {
    a[0] = -std::sin(q[0]);
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
  void jacobian(double, const double* q, double* j) const {
    j[0] = j[3] = 0;
    j[1] = 1;
    j[2] = -std::cos(q[0]);
  }
  double energy(const double* y) const { return y[1] * y[1] / 2 - std::cos(y[0]); }
};

Case make_case(const char* id, const char* title, const Values& values) {
  Case c;
  c.id = id;
  c.title = title;
  c.equation = "theta'' = -sin theta, theta(0) = theta0, theta'(0) = rate0";
  c.source = "Huygens 1673; closed form in Jacobi's elliptic functions";
  c.tags = {"nonlinear", "autonomous", "second_order", "separable", "mechanical", "oscillatory"};
  c.y0 = {values[0], values[1]};
  c.components = {"theta", "rate"};
  c.stops = {1, 5, 10};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 40;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.settings.timed_stops = {100};
  c.settings.timed_floor = 1e-25;
  c.truth = reference_truth(id, 1e-25);
  set_stage(c, Pendulum{});
  return c;
}

Case make_variant(const char* id, const char* title, double angle) {
  return with_tabled_parameters(
      {{"theta0", angle, "angle at the start, rad"},
       {"rate0", 0, "angular velocity at the start, rad/s, times sqrt(l/g)"}},
      [=](const Values& values) { return make_case(id, title, values); });
}

}  // namespace

/// A pendulum with amplitudes of 1 and 3 rad, the latter close to the separatrix.
std::vector<Case> pendulum() {
  return {make_variant("pendulum_small", "Pendulum", 1),
          make_variant("pendulum_large", "Pendulum that nearly turns over", 3)};
}

}  // namespace odeum::cases
