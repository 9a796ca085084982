// SPDX-License-Identifier: BSD-3-Clause
#include "problems/oscillator.hpp"

#include <fmt/format.h>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/stage.hpp"
#include "odeum/problem/damped_oscillator.hpp"

namespace odeum::cases {
namespace {

struct Variant {
  const char* id;
  const char* reference;
  const char* title;
  double damping, floor;
};

// c, x0, v0, in the order of the parameters. The reference holds for its damping and start.
template <bool Damped>
Case make_case(const Variant& variant, const Values& values) {
  const double damping = values[0];
  Case c;
  c.id = variant.id;
  c.title = variant.title;
  c.equation = fmt::format("x'' + c x' + x = 0, x(0) = {}, x'(0) = {}, c = {}", values[1],
                           values[2], damping);
  c.source = "harmonic oscillator with viscous damping, any mechanics text";
  c.tags = {"linear", "autonomous", "second_order", "mechanical"};
  c.tags.emplace_back(Damped ? "damped" : "separable");
  c.y0 = {values[1], values[2]};
  c.components = {"x", "v"};
  c.stops = {1, 5, 10, 20};
  c.settings.steps_multiple = 20;
  c.settings.coarsest_steps = 80;
  c.settings.finest_steps = 2560;
  c.settings.evaluation_budget = 20'000;
  if (values == Values{variant.damping, 1, 0.5}) {
    c.truth = reference_truth(variant.reference, variant.floor);
  } else {
    c.truth.source = "closed form";
    c.truth.at = [damping, y0 = c.y0](double t, double* y) {
      damped_oscillator_solution(1, damping, 1, y0[0], y0[1], t, y);
      return true;
    };
  }
  set_stage(c, UnitOscillator<Damped>{damping});
  return c;
}

Case make_variant(const Variant& variant) {
  return with_parameters({{"c", variant.damping, "damping, 2 is critical"},
                          {"x0", 1, "x at the start"},
                          {"v0", 0.5, "x' at the start"}},
                         [variant](const Values& values) {
                           require_not_negative("c", values[0]);
                           return values[0] > 0 ? make_case<true>(variant, values)
                                                : make_case<false>(variant, values);
                         });
}

}  // namespace

/// Linear oscillators on both sides of critical damping, where the two roots coincide.
std::vector<Case> oscillator() {
  return {make_variant({"osc_undamped", "osc_undamped", "Oscillator, no damping", 0, 1e-25}),
          make_variant({"osc_under", "osc_under", "Oscillator, slight damping", 0.2, 2.5e-17}),
          make_variant({"osc_critical", "osc_critical", "Oscillator, critical damping", 2, 1e-25}),
          make_variant({"osc_nearly_critical", "osc_nearcrit_above_1e-6",
                        "Oscillator, a millionth above critical damping", 2.000002, 4e-17}),
          make_variant({"osc_over", "osc_over", "Oscillator, strong damping", 4, 1e-25})};
}

}  // namespace odeum::cases
