// SPDX-License-Identifier: BSD-3-Clause
#include "problems/oscillator.hpp"
#include "support/reference.hpp"
#include "support/stage.hpp"

namespace odeum::cases {
namespace {

template <bool Damped>
Case make_variant(const char* id, const char* reference, const char* title, double damping,
                  double floor) {
  Case c;
  c.id = id;
  c.title = title;
  c.equation = "x'' + c x' + x = 0, x(0) = 1, x'(0) = 0.5, c = " + std::to_string(damping);
  c.source = "harmonic oscillator with viscous damping, any mechanics text";
  c.tags = {"linear", "autonomous", "second_order", "mechanical"};
  c.tags.emplace_back(Damped ? "damped" : "separable");
  c.y0 = {1, 0.5};
  c.stops = {1, 5, 10, 20};
  c.settings.steps_multiple = 20;
  c.settings.coarsest_steps = 80;
  c.settings.finest_steps = 2560;
  c.settings.evaluation_budget = 20'000;
  c.truth = reference_truth(reference, floor);
  set_stage(c, UnitOscillator<Damped>{damping});
  return c;
}

}  // namespace

/// Linear oscillators on both sides of critical damping, where the two roots coincide.
std::vector<Case> oscillator() {
  return {
      make_variant<false>("osc_undamped", "osc_undamped", "Oscillator, no damping", 0, 1e-25),
      make_variant<true>("osc_under", "osc_under", "Oscillator, slight damping", 0.2, 2.5e-17),
      make_variant<true>("osc_critical", "osc_critical", "Oscillator, critical damping", 2, 1e-25),
      make_variant<true>("osc_nearly_critical", "osc_nearcrit_above_1e-6",
                         "Oscillator, a millionth above critical damping", 2.000002, 4e-17),
      make_variant<true>("osc_over", "osc_over", "Oscillator, strong damping", 4, 1e-25)};
}

}  // namespace odeum::cases
