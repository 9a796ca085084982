// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// x'' = -x - x^3 / 2.
struct Duffing {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = false;
  double alpha = 1, beta = 0.5;

  template <class R>
  void acceleration(R, const R* q, const R*, R* a) const {
    a[0] = -q[0] * (alpha + beta * q[0] * q[0]);
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
  void jacobian(double, const double* q, double* j) const {
    j[0] = j[3] = 0;
    j[1] = 1;
    j[2] = -alpha - 3 * beta * q[0] * q[0];
  }
  double energy(const double* y) const {
    const double x2 = y[0] * y[0];
    return (y[1] * y[1] + alpha * x2) / 2 + beta * x2 * x2 / 4;
  }
};

Case make_case(const Values& values) {
  Case c;
  c.id = "duffing_free";
  c.title = "Duffing's hardening spring";
  c.equation = "x'' = -alpha x - beta x^3, x(0) = x0, x'(0) = v0";
  c.source = "Duffing 1918; closed form in Jacobi's elliptic functions";
  c.tags = {"nonlinear",  "autonomous",  "second_order", "separable",
            "mechanical", "oscillatory", "smooth"};
  c.y0 = {values[2], values[3]};
  c.components = {"x", "v"};
  c.stops = {1, 5};
  c.settings.steps_multiple = 5;
  c.settings.coarsest_steps = 20;
  c.settings.finest_steps = 20480;
  c.settings.timed_stops = {100};
  c.settings.timed_floor = 1e-25;
  c.truth = reference_truth("duffing_free", 1e-25);
  set_stage(c, Duffing{values[0], values[1]});
  return c;
}

}  // namespace

/// A hardening spring.
std::vector<Case> duffing() {
  return {with_tabled_parameters({{"alpha", 1, "stiffness"},
                                  {"beta", 0.5, "hardening (below 0: softening)"},
                                  {"x0", 1, "x at the start"},
                                  {"v0", 0, "x' at the start"}},
                                 make_case)};
}

}  // namespace odeum::cases
