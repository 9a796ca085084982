// SPDX-License-Identifier: BSD-3-Clause
#include "problems/hires.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {

/// High irradiance response: eight stiff reactions.
std::vector<Case> hires() {
  Case c;
  c.id = "hires";
  c.title = "High irradiance response";
  c.equation = "eight chemical reactions, y' = f(y), one of them quadratic; the index has them all";
  c.source =
      "Schaefer, J. Math. Biol. 2 (1975); Hairer, Wanner, Solving ODEs II, IV.10; Test Set for IVP "
      "Solvers, HIRES";
  c.tags = {"nonlinear", "autonomous", "stiff", "chemistry"};
  c.y0 = {1, 0, 0, 0, 0, 0, 0, 0.0057};
  c.stops = {321.8122};
  c.settings.coarsest_steps = 2048;
  c.settings.finest_steps = 8192;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth("hires", 1.5e-15);
  c.invariants = {{"mass", [](const double* y) { return y[6] + y[7]; }}};
  set_stage(c, Hires{});
  return {c};
}

}  // namespace odeum::cases
