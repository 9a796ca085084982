// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// x'' = -x - 2 x y,  y'' = -y - x^2 + y^2.
struct HenonHeiles {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = false;

  template <class R>
  void acceleration(R, const R* q, const R*, R* a) const {
    a[0] = -q[0] - 2 * q[0] * q[1];
    a[1] = -q[1] - q[0] * q[0] + q[1] * q[1];
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 2, t, y, dydt);
  }
  void jacobian(double, const double* q, double* j) const {
    for (int i = 0; i < 16; ++i) j[i] = 0;
    j[2] = j[7] = 1;
    j[8] = -1 - 2 * q[1];
    j[9] = j[12] = -2 * q[0];
    j[13] = -1 + 2 * q[1];
  }
  double energy(const double* y) const {
    return (y[2] * y[2] + y[3] * y[3] + y[0] * y[0] + y[1] * y[1]) / 2 + y[0] * y[0] * y[1] -
           y[1] * y[1] * y[1] / 3;
  }
};

Case make_case(const Values& values) {
  Case c;
  c.id = "henon_heiles_regular";
  c.title = "Henon and Heiles's star";
  c.equation = "x'' = -x - 2 x y, y'' = -y - x^2 + y^2";
  c.source = "Henon, Heiles, Astron. J. 69 (1964) 73";
  c.tags = {"nonlinear", "autonomous", "second_order", "separable", "celestial", "smooth"};
  c.y0 = values;
  c.components = {"x", "y", "vx", "vy"};
  c.stops = {10};
  c.settings.coarsest_steps = 40;
  c.settings.finest_steps = 40960;
  c.settings.timed_stops = {100};
  c.settings.timed_floor = 6e-16;
  c.truth = reference_truth("henon_heiles_regular", 2e-16);
  set_stage(c, HenonHeiles{});
  return c;
}

}  // namespace

/// Henon and Heiles's model of a star in a galaxy, at an energy where the orbit is regular.
std::vector<Case> henon_heiles() {
  return {with_tabled_parameters({{"x0", 0.1, "x at the start"},
                                  {"y0", 0, "y at the start"},
                                  {"vx0", 0, "x' at the start"},
                                  {"vy0", 0.4, "y' at the start"}},
                                 make_case)};
}

}  // namespace odeum::cases
