// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// y' = -lambda (y - cos t) - sin t, which cos t solves.
struct ProtheroRobinson {
  static constexpr std::size_t dimension = 1;
  double lambda;

  void rhs(double t, const double* y, double* f) const {
    f[0] = -lambda * (y[0] - std::cos(t)) - std::sin(t);
  }
  void jacobian(double, const double*, double* j) const { j[0] = -lambda; }
  void time_derivative(double t, const double*, double* d) const {
    d[0] = -lambda * std::sin(t) - std::cos(t);
  }
};

Case make_variant(const char* id, const char* title, const char* equation, double lambda,
                  double start) {
  Case c;
  c.id = id;
  c.title = title;
  c.equation = equation;
  c.source =
      "Prothero, Robinson, Math. Comp. 28 (1974) 145; Hairer, Wanner, Solving ODEs II, IV.15";
  c.tags = {"linear", "non_autonomous", "stiff", "order_reduction"};
  c.y0 = {start};
  c.stops = {1, 10};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 40;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth(id, 1e-25);
  set_stage(c, ProtheroRobinson{lambda});
  return c;
}

}  // namespace

/// Order reduction of implicit methods to their stage order, without and with an initial layer.
std::vector<Case> prothero_robinson() {
  return {
      make_variant("prothero_robinson_1e3_smooth", "Prothero and Robinson's problem",
                   "y' = -1e3 (y - cos t) - sin t, y(0) = 1", 1e3, 1),
      make_variant("prothero_robinson_1e3_layer", "Prothero and Robinson's problem, off its curve",
                   "y' = -1e3 (y - cos t) - sin t, y(0) = 2", 1e3, 2),
      make_variant("prothero_robinson_1e6_smooth", "Prothero and Robinson's problem, stiffer",
                   "y' = -1e6 (y - cos t) - sin t, y(0) = 1", 1e6, 1)};
}

}  // namespace odeum::cases
