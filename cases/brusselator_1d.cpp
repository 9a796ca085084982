// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/set_problem.hpp"
#include "problems/two_species.hpp"

namespace odeum::cases {
std::vector<double> brusselator_1d_start(std::size_t cells) {
  std::vector<double> y;
  for (std::size_t i = 1; i <= cells; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(cells + 1);
    y.push_back(1 + std::sin(2 * std::numbers::pi * x));
    y.push_back(3);
  }
  return y;
}

namespace {

Case make_brusselator_1d() {
  Case c;
  c.nature.stiff = true;
  c.equation =
      "u_i' = 1 + u_i^2 v_i - 4 u_i + c (u_{i-1} - 2 u_i + u_{i+1}), v_i' = 3 u_i - u_i^2 v_i + c "
      "(v_{i-1} - 2 v_i + v_{i+1}), i = 1..500, c = 0.02 * 501^2, u = 1 and v = 3 at the ends, "
      "u_i(0) = 1 + sin(2 pi i / 501), v_i(0) = 3";
  c.source = "Hairer, Wanner, Solving ODEs II, IV.1, (1.6'), and IV.10, problem BRUSS";
  c.y0 = brusselator_1d_start(500);
  c.stops = {2, 4, 6, 8, 10};
  c.settings.steps_multiple = 5;
  c.settings.coarsest_steps = 40;
  c.settings.finest_steps = 1280;
  c.settings.evaluation_budget = 20'000;
  c.truth = reference_truth("brusselator_1d", 2e-15);
  set_problem(c, brusselator_1d_problem(500));
  return c;
}

}  // namespace

/// A reaction with diffusion on 500 cells: 1,000 unknowns with a band of two on either side.
std::vector<Statement> brusselator_1d() {
  return {{.id = "brusselator_1d",
           .title = "Brusselator with diffusion",
           .tags = {"diffusion"},
           .make = make_brusselator_1d}};
}

}  // namespace odeum::cases
