// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// x' = a x - b x y,  y' = -c y + d x y.
struct LotkaVolterra {
  static constexpr std::size_t dimension = 2;
  double a = 1.5, b = 1, c = 3, d = 1;

  template <class R>
  void rhs(R, const R* y, R* dydt) const {
    dydt[0] = (a - b * y[1]) * y[0];
    dydt[1] = (d * y[0] - c) * y[1];
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = a - b * y[1];
    j[1] = -b * y[0];
    j[2] = d * y[1];
    j[3] = d * y[0] - c;
  }
  void taylor(double, const double* y, int order, double* series) const {
    std::copy_n(y, 2, series);
    for (int k = 0; k < order; ++k) {
      double product = 0;  // of the two series
      for (int j = 0; j <= k; ++j) product += series[2 * j] * series[2 * (k - j) + 1];
      series[2 * k + 2] = (a * series[2 * k] - b * product) / (k + 1);
      series[2 * k + 3] = (d * product - c * series[2 * k + 1]) / (k + 1);
    }
  }
};

Case make_case(const Values& values) {
  const LotkaVolterra problem{values[0], values[1], values[2], values[3]};
  Case c;
  c.id = "lotka_volterra";
  c.title = "Predator and prey";
  c.equation = "x' = a x - b x y, y' = -c y + d x y, x(0) = x0, y(0) = y0";
  c.source = "Lotka 1925; Volterra 1926";
  c.tags = {"nonlinear", "autonomous", "smooth"};
  c.y0 = {values[4], values[5]};
  c.components = {"prey", "predators"};
  c.stops = {1, 2, 5, 10};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 40;
  c.settings.finest_steps = 40960;
  c.truth = reference_truth("lotka_volterra", 1e-16);
  set_stage(c, problem);
  return c;
}

}  // namespace

/// Predator and prey: nonlinear and coupled, a closed orbit.
std::vector<Case> lotka_volterra() {
  return {with_tabled_parameters({{"a", 1.5, "growth of the prey, 1/s"},
                                  {"b", 1, "prey eaten per predator, 1/s"},
                                  {"c", 3, "death of the predators, 1/s"},
                                  {"d", 1, "growth of the predators per prey, 1/s"},
                                  {"x0", 1, "prey at the start"},
                                  {"y0", 1, "predators at the start"}},
                                 make_case)};
}

}  // namespace odeum::cases
