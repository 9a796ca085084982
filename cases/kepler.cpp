// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"
#include "problems/kepler.hpp"

namespace odeum::cases {
namespace {

Case describe(const char* id, const char* title, double eccentricity, double floor) {
  require_not_negative("e", eccentricity);
  require_positive("1 - e", 1 - eccentricity);
  Case c;
  c.id = id;
  c.title = title;
  c.equation = "q'' = -q / |q|^3 from the pericentre of an orbit of period 2 pi";
  c.source = "Newton 1687; Hairer, Lubich, Wanner, Geometric Numerical Integration, I.2";
  c.tags = {"nonlinear", "autonomous", "second_order", "separable", "celestial"};
  c.components = {"x", "y", "vx", "vy"};
  c.y0 = {1 - eccentricity, 0, 0, std::sqrt((1 + eccentricity) / (1 - eccentricity))};
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth(id, floor);
  c.invariants = {{"angular_momentum", [](const double* y) { return y[0] * y[3] - y[1] * y[2]; }}};
  return c;
}

Case make_moderate(const Values& values) {
  Case c = describe("kepler_e06", "Kepler's ellipse, e = 0.6", values[0], 7e-16);
  c.stops = {1, 3};
  c.settings.steps_multiple = 3;
  c.settings.coarsest_steps = 96;
  c.settings.finest_steps = 24576;
  c.settings.evaluation_budget = 500'000;
  c.tags.emplace_back("smooth");
  // A hundred periods. Rounding 200 pi to double shifts the time by at most 5.7e-14.
  c.settings.timed_stops = {200 * std::numbers::pi};
  c.settings.timed_floor = 2e-12;
  set_stage(c, Kepler{});
  return c;
}

Case make_narrow(const Values& values) {
  Case c = describe("kepler_e09", "Kepler's ellipse, e = 0.9", values[0], 2.2e-14);
  c.stops = {1, 3, 10};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 320;
  c.settings.finest_steps = 10240;
  set_stage(c, Kepler{});
  return c;
}

}  // namespace

/// Kepler's problem with eccentricities 0.6 and 0.9.
std::vector<Case> kepler() {
  return {with_tabled_parameters({{"e", 0.6, "eccentricity, 0 to below 1"}}, make_moderate),
          with_tabled_parameters({{"e", 0.9, "eccentricity, 0 to below 1"}}, make_narrow)};
}

}  // namespace odeum::cases
