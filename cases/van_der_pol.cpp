// SPDX-License-Identifier: BSD-3-Clause
#include "problems/van_der_pol.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

constexpr const char* jumps =
    "a fixed step would have to resolve jumps a million times shorter than the period";

Case describe(const char* id, const char* reference, const char* title, const Values& start,
              std::vector<double> stops) {
  Case c;
  c.id = id;
  c.title = title;
  c.source = "van der Pol 1926; Hairer, Wanner, Solving ODEs II, (IV.1.5')";
  c.tags = {"nonlinear", "autonomous", "oscillatory"};
  c.y0 = start;
  c.components = {"x", "v"};
  c.stops = std::move(stops);
  c.settings.evaluation_budget = 60'000;
  c.truth = reference_truth(reference, 1e-25);
  return c;
}

Case make_mild(const Values& values) {
  Case c = describe("vdp_mu1", "vdp_mu1", "Van der Pol's oscillator", {values[1], values[2]},
                    {1, 5, 10});
  c.settings.steps_multiple = 10;
  c.settings.coarsest_steps = 80;
  c.settings.finest_steps = 10240;
  c.equation = "x'' = mu (1 - x^2) x' - x, x(0) = x0, x'(0) = v0";
  set_stage(c, VanDerPol{.mu = values[0]});
  return c;
}

Case make_slow(const Values& values) {
  Case c = describe("vdp_mu1000", "vdp_mu1000", "Van der Pol's oscillator, mu = 1000",
                    {values[1], values[2]}, {1000, 2000});
  c.equation = "x'' = mu (1 - x^2) x' - x, x(0) = x0, x'(0) = v0";
  c.tags.emplace_back("stiff");
  c.settings.no_fixed_steps = jumps;
  set_stage(c, VanDerPol{.mu = values[0]});
  return c;
}

Case make_stiff(const Values& values) {
  require_positive("eps", values[0]);
  Case c = describe("vdp_eps1e_6", "vdp_eps1e-6", "Van der Pol's oscillator, eps = 1e-6",
                    {values[1], values[2]}, {1, 2});
  c.equation = "eps x'' = (1 - x^2) x' - x, x(0) = x0, x'(0) = v0";
  c.tags.emplace_back("stiff");
  c.settings.no_fixed_steps = jumps;
  set_stage(c, VanDerPol{.eps = values[0]});
  return c;
}

std::vector<Parameter> parameters(Parameter strength) {
  return {std::move(strength), {"x0", 2, "x at the start"}, {"v0", 0, "x' at the start"}};
}

}  // namespace

/// Van der Pol's oscillator at three stiffnesses.
std::vector<Case> van_der_pol() {
  return {with_tabled_parameters(parameters({"mu", 1, "strength of the damping"}), make_mild),
          with_tabled_parameters(parameters({"mu", 1000, "strength of the damping"}), make_slow),
          with_tabled_parameters(parameters({"eps", 1e-6, "time of a jump over the period"}),
                                 make_stiff)};
}

}  // namespace odeum::cases
