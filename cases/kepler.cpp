// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "problems/kepler.hpp"
#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

Case describe(const char* id, const char* title, double eccentricity, double floor) {
  Case c;
  c.id = id;
  c.title = title;
  c.equation = "q'' = -q / |q|^3 from the pericentre of an orbit of period 2 pi";
  c.source = "Newton 1687; Hairer, Lubich, Wanner, Geometric Numerical Integration, I.2";
  c.tags = {"nonlinear", "autonomous", "second_order", "separable", "celestial"};
  c.y0 = {1 - eccentricity, 0, 0, std::sqrt((1 + eccentricity) / (1 - eccentricity))};
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth(id, floor);
  c.invariants = {{"angular_momentum", [](const double* y) { return y[0] * y[3] - y[1] * y[2]; }}};
  return c;
}

}  // namespace

/// Kepler's problem with eccentricities 0.6 and 0.9.
std::vector<Case> kepler() {
  Case moderate = describe("kepler_e06", "Kepler's ellipse, e = 0.6", 0.6, 7e-16);
  moderate.stops = {1, 3};
  moderate.settings.steps_multiple = 3;
  moderate.settings.coarsest_steps = 96;
  moderate.settings.finest_steps = 24576;
  moderate.settings.evaluation_budget = 500'000;
  moderate.tags.emplace_back("smooth");
  // A hundred periods. Rounding 200 pi to double shifts the time by at most 5.7e-14.
  moderate.settings.timed_stops = {200 * std::numbers::pi};
  moderate.settings.timed_floor = 2e-12;
  set_stage(moderate, Kepler{});

  Case narrow = describe("kepler_e09", "Kepler's ellipse, e = 0.9", 0.9, 2.2e-14);
  narrow.stops = {1, 3, 10};
  narrow.settings.steps_multiple = 10;
  narrow.settings.coarsest_steps = 320;
  narrow.settings.finest_steps = 10240;
  set_stage(narrow, Kepler{});
  return {moderate, narrow};
}

}  // namespace odeum::cases
