// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

/// y' = -lambda (y - cos t) - sin t, which cos t solves.
struct ProtheroRobinson {
  static constexpr std::size_t dimension = 1;
  double lambda;

  template <class R>
  void rhs(R t, const R* y, R* f) const {
    f[0] = -lambda * (y[0] - std::cos(t)) - std::sin(t);
  }
  void jacobian(double, const double*, double* j) const { j[0] = -lambda; }
  void time_derivative(double t, const double*, double* d) const {
    d[0] = -lambda * std::sin(t) - std::cos(t);
  }
};

Case make_case(const char* id, const char* title, bool usual, double lambda, double start) {
  Case c;
  c.id = id;
  c.title = title;
  c.equation = fmt::format("y' = -{} (y - cos t) - sin t, y(0) = {}", lambda, start);
  c.source =
      "Prothero, Robinson, Math. Comp. 28 (1974) 145; Hairer, Wanner, Solving ODEs II, IV.15";
  c.tags = {"linear", "non_autonomous", "stiff", "order_reduction"};
  c.y0 = {start};
  c.stops = {1, 10};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 40;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.components = {"y"};
  c.truth = reference_truth(id, 1e-25);
  if (!usual) {
    c.truth.source = "closed form";
    c.truth.floor = 0;
    c.truth.at = [lambda, start](double t, double* y) {
      y[0] = std::cos(t) + (start - 1) * std::exp(-lambda * t);
      return true;
    };
  }
  set_stage(c, ProtheroRobinson{lambda});
  return c;
}

Case make_variant(const char* id, const char* title, double lambda, double start) {
  return with_parameters({{"lambda", lambda, "how fast it returns to cos t, 1/s"},
                          {"y0", start, "at the start; 1: on the curve"}},
                         [=](const Values& values) {
                           const bool usual = values == Values{lambda, start};
                           return make_case(id, title, usual, values[0], values[1]);
                         });
}

}  // namespace

/// Order reduction of implicit methods to their stage order, without and with an initial layer.
std::vector<Case> prothero_robinson() {
  return {make_variant("prothero_robinson_1e3_smooth", "Prothero and Robinson's problem", 1e3, 1),
          make_variant("prothero_robinson_1e3_layer",
                       "Prothero and Robinson's problem, off its curve", 1e3, 2),
          make_variant("prothero_robinson_1e6_smooth", "Prothero and Robinson's problem, stiffer",
                       1e6, 1)};
}

}  // namespace odeum::cases
