// SPDX-License-Identifier: BSD-3-Clause
#include "problems/robertson.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

Case describe(const char* id, const char* title) {
  Case c;
  c.id = id;
  c.title = title;
  c.equation =
      "y1' = -k1 y1 + k3 y2 y3, y2' = k1 y1 - k3 y2 y3 - k2 y2^2, y3' = k2 y2^2, y(0) = (1, 0, 0)";
  c.source = "Robertson 1966; Hairer, Wanner, Solving ODEs II, (IV.1.4)";
  c.tags = {"nonlinear", "autonomous", "stiff", "chemistry"};
  c.y0 = {1, 0, 0};
  // The absolute tolerances of CVODE's example cvRoberts_dns are 1e-8, 1e-14 and 1e-6, the relative
  // one 1e-4: y2 is never above 4e-5.
  c.tolerance = Tolerance::of_thresholds(0, {1e-4, 1e-10, 1e-2});
  c.settings.evaluation_budget = 60'000;
  c.truth = reference_truth("robertson", 1e-17);
  c.invariants = {{"mass", [](const double* y) { return y[0] + y[1] + y[2]; }}};
  return c;
}

Case make_brief(const Values& values) {
  Case c = describe("robertson_40", "Robertson's reactions");
  c.stops = {4, 40};
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 1000;
  c.settings.finest_steps = 16000;
  set_stage(c, Robertson{values[0], values[1], values[2]});
  return c;
}

Case make_long(const Values& values) {
  Case c = describe("robertson", "Robertson's reactions to equilibrium");
  c.stops = {0.4, 40, 4e3, 4e5, 4e7, 4e9, 4e11};
  c.settings.no_fixed_steps =
      "twelve decades of time: no fixed step resolves the first and reaches the last";
  set_stage(c, Robertson{values[0], values[1], values[2]});
  return c;
}

}  // namespace

/// Robertson's reactions to t = 40, and to equilibrium at t = 4e11.
std::vector<Case> robertson() {
  const std::vector<Parameter> rates{{"k1", 0.04, "rate of y1 to y2, 1/s"},
                                     {"k2", 3e7, "rate of y2 and y2 to y3, 1/s"},
                                     {"k3", 1e4, "rate of y2 and y3 to y1, 1/s"}};
  return {with_tabled_parameters(rates, make_brief), with_tabled_parameters(rates, make_long)};
}

}  // namespace odeum::cases
