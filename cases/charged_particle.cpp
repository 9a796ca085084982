// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// x'' = w y', y'' = -w x', z'' = 0.
struct ChargedParticle {
  static constexpr std::size_t dimension = 6;
  static constexpr bool velocity_dependent = true;
  double w = 2;

  template <class R>
  void acceleration(R, const R*, const R* v, R* a) const {
    a[0] = w * v[1];
    a[1] = -w * v[0];
    a[2] = 0;
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 3, t, y, dydt);
  }
  void jacobian(double, const double*, double* j) const {
    for (int i = 0; i < 36; ++i) j[i] = 0;
    for (int i = 0; i < 3; ++i) j[6 * i + 3 + i] = 1;
    j[6 * 3 + 4] = w;
    j[6 * 4 + 3] = -w;
  }
  /// Per unit mass.
  double energy(const double* y) const { return (y[3] * y[3] + y[4] * y[4] + y[5] * y[5]) / 2; }
};

Case make_case(const Values& values) {
  Case c;
  c.id = "charged_particle";
  c.title = "Charge in a magnetic field";
  c.equation = "x'' = w y', y'' = -w x', z'' = 0, v(0) = (vx, vy, vz)";
  c.source = "Lorentz force, any electrodynamics text";
  c.tags = {"linear", "autonomous", "second_order", "mechanical", "oscillatory"};
  c.y0 = {0, 0, 0, values[1], values[2], values[3]};
  c.components = {"x", "y", "z", "vx", "vy", "vz"};
  c.stops = {1, 5, 10};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 80;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.settings.timed_stops = {100};
  c.settings.timed_floor = 1e-25;
  c.truth = reference_truth("charged_particle", 1e-25);
  c.invariants = {{"velocity_z", [](const double* y) { return y[5]; }}};
  set_stage(c, ChargedParticle{values[0]});
  return c;
}

}  // namespace

/// A charge in a uniform magnetic field.
std::vector<Case> charged_particle() {
  return {with_tabled_parameters({{"w", 2, "charge times field over mass, 1/s"},
                                  {"vx", 1, "velocity at the start, m/s"},
                                  {"vy", 0.5, "velocity at the start, m/s"},
                                  {"vz", 0.25, "along the field, m/s"}},
                                 make_case)};
}

}  // namespace odeum::cases
