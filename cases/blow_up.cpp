// SPDX-License-Identifier: BSD-3-Clause
#include <limits>

#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// y' = y^2.
struct BlowUp {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = y[0] * y[0]; }
  void jacobian(double, const double* y, double* j) const { j[0] = 2 * y[0]; }
};

}  // namespace

/// A solution that ends at a pole, t = 1, within the interval: a solver that reports success at the
/// end has stepped over it, to the other branch of 1 / (1 - t).
std::vector<Case> blow_up() {
  Case c;
  c.id = "blow_up";
  c.title = "Solution that ends at a pole";
  c.equation = "y' = y^2, y(0) = 1: y = 1 / (1 - t) for t < 1, and no solution from there on";
  c.source = "by separation of variables";
  c.tags = {"nonlinear", "autonomous", "ends"};
  c.y0 = {1};
  c.stops = {0.5, 2};
  c.settings.steps_multiple = 4;
  c.truth.source = "closed form";
  c.truth.at = [](double t, double* y) {
    y[0] = t < 1 ? 1 / (1 - t) : std::numeric_limits<double>::infinity();
    return true;
  };
  set_stage(c, BlowUp{});
  return {c};
}

}  // namespace odeum::cases
