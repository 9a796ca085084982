// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// u' = A + u^2 v - (B + 1) u,  v' = B u - u^2 v,  A = 1, B = 3.
struct Brusselator {
  static constexpr std::size_t dimension = 2;
  double A = 1, B = 3;

  template <class R>
  void rhs(R, const R* y, R* f) const {
    const R autocatalysis = y[0] * y[0] * y[1];
    f[0] = A + autocatalysis - (B + 1) * y[0];
    f[1] = B * y[0] - autocatalysis;
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = 2 * y[0] * y[1] - B - 1;
    j[1] = y[0] * y[0];
    j[2] = B - 2 * y[0] * y[1];
    j[3] = -y[0] * y[0];
  }
};

Case make_case(const Values& values) {
  Case c;
  c.id = "brusselator2";
  c.title = "Brusselator";
  c.equation = "u' = A + u^2 v - (B + 1) u, v' = B u - u^2 v, u(0) = u0, v(0) = v0";
  c.source = "Lefever, Nicolis 1971; Hairer, Norsett, Wanner, Solving ODEs I, (I.16.12), (II.4.15)";
  c.tags = {"nonlinear", "autonomous", "oscillatory", "chemistry"};
  c.y0 = {values[2], values[3]};
  c.components = {"u", "v"};
  c.stops = {1, 5, 10, 20};
  c.settings.steps_multiple = 20;
  c.settings.coarsest_steps = 160;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth("brusselator2", 1e-25);
  set_stage(c, Brusselator{values[0], values[1]});
  return c;
}

}  // namespace

/// A chemical oscillator with an attracting limit cycle.
std::vector<Case> brusselator() {
  return {with_tabled_parameters({{"A", 1, "feed of u"},
                                  {"B", 3, "feed of the other reactant"},
                                  {"u0", 1.5, "u at the start"},
                                  {"v0", 3, "v at the start"}},
                                 make_case)};
}

}  // namespace odeum::cases
