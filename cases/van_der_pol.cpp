// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "problems/van_der_pol.hpp"
#include "support/parameters.hpp"
#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

Case describe(const char* id, const char* reference, const char* title, const char* equation,
              std::vector<double> stops) {
  Case c;
  c.id = id;
  c.title = title;
  c.equation = equation;
  c.source = "van der Pol 1926; Hairer, Wanner, Solving ODEs II, (IV.1.5')";
  c.tags = {"nonlinear", "autonomous", "oscillatory"};
  c.y0 = {2, 0};
  c.components = {"x", "v"};
  c.stops = std::move(stops);
  c.settings.evaluation_budget = 60'000;
  c.truth = reference_truth(reference, 1e-25);
  return c;
}

Case make_mild(const Values& values) {
  Case c = describe("vdp_mu1", "vdp_mu1", "Van der Pol's oscillator",
                    "x'' = (1 - x^2) x' - x, x(0) = 2, x'(0) = 0", {1, 5, 10});
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 80;
  c.settings.finest_steps = 10240;
  if (values != Values{1, 2, 0}) {
    c.y0 = {values[1], values[2]};
    c.equation = fmt::format("x'' = {} (1 - x^2) x' - x, x(0) = {}, x'(0) = {}", values[0],
                             values[1], values[2]);
    c.truth = unknown_truth();
  }
  set_stage(c, VanDerPol{.mu = values[0]});
  return c;
}

constexpr const char* jumps =
    "a fixed step would have to resolve jumps a million times shorter than the period";

}  // namespace

/// Van der Pol's oscillator at three stiffnesses.
std::vector<Case> van_der_pol() {
  const Case mild = with_parameters({{"mu", 1, "strength of the damping"},
                                     {"x0", 2, "x at the start"},
                                     {"v0", 0, "x' at the start"}},
                                    make_mild);
  Case slow = describe("vdp_mu1000", "vdp_mu1000", "Van der Pol's oscillator, mu = 1000",
                       "x'' = 1000 (1 - x^2) x' - x, x(0) = 2, x'(0) = 0", {1000, 2000});
  slow.tags.emplace_back("stiff");
  slow.settings.no_fixed_steps = jumps;
  set_stage(slow, VanDerPol{.mu = 1000});

  Case stiff = describe("vdp_eps1e_6", "vdp_eps1e-6", "Van der Pol's oscillator, eps = 1e-6",
                        "1e-6 x'' = (1 - x^2) x' - x, x(0) = 2, x'(0) = 0", {1, 2});
  stiff.tags.emplace_back("stiff");
  stiff.settings.no_fixed_steps = jumps;
  set_stage(stiff, VanDerPol{.eps = 1e-6});
  return {mild, slow, stiff};
}

}  // namespace odeum::cases
