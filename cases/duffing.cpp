// SPDX-License-Identifier: BSD-3-Clause
#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// x'' = -x - x^3 / 2.
struct Duffing {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = false;

  void acceleration(double, const double* q, const double*, double* a) const {
    a[0] = -q[0] * (1 + q[0] * q[0] / 2);
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
  void jacobian(double, const double* q, double* j) const {
    j[0] = j[3] = 0;
    j[1] = 1;
    j[2] = -1 - 1.5 * q[0] * q[0];
  }
  double energy(const double* y) const {
    const double x2 = y[0] * y[0];
    return (y[1] * y[1] + x2) / 2 + x2 * x2 / 8;
  }
};

}  // namespace

/// A hardening spring.
std::vector<Case> duffing() {
  Case c;
  c.id = "duffing_free";
  c.title = "Duffing's hardening spring";
  c.equation = "x'' = -x - x^3 / 2, x(0) = 1, x'(0) = 0";
  c.source = "Duffing 1918; closed form in Jacobi's elliptic functions";
  c.tags = {"nonlinear",  "autonomous",  "second_order", "separable",
            "mechanical", "oscillatory", "smooth"};
  c.y0 = {1, 0};
  c.stops = {1, 5};
  c.settings.steps_multiple = 5;
  c.settings.coarsest_steps = 20;
  c.settings.finest_steps = 20480;
  c.settings.timed_stops = {100};
  c.settings.timed_floor = 1e-25;
  c.truth = reference_truth("duffing_free", 1e-25);
  set_stage(c, Duffing{});
  return {c};
}

}  // namespace odeum::cases
