// SPDX-License-Identifier: BSD-3-Clause
#include "problems/oscillator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/problem/damped_oscillator.hpp"
#include "odeum/scene/model/scene.hpp"

namespace odeum::cases {
namespace {

/// What all oscillators have in common.
template <class Numbers>
Case describe(const Numbers& n, double y0, double v0) {
  Case c;
  c.nature.linear = true;
  c.source = "harmonic oscillator with viscous damping, any mechanics text";
  c.y0 = {y0, v0};
  c.truth.source = "closed form";
  c.truth.closed_form = true;
  c.truth.at = [n, y0, v0](double t, double* y) {
    damped_oscillator_solution(n.m, n.d, n.k, y0 - n.rest, v0, t, y);
    y[0] += n.rest;
    return true;
  };
  return c;
}

/// x'' + c x' + x = 0 near a kind of damping, with a reference for that damping and the usual
/// start.
struct UnitVariant {
  const char* id;
  const char* reference;
  const char* title;
  double damping, floor;
};

Case make_unit(const UnitVariant& variant) {
  return with_parameters({{"c", variant.damping, "damping, 2 is critical"},
                          {"x0", 1, "x at the start"},
                          {"v0", 0.5, "x' at the start"}},
                         [variant](const Values& values) {
                           require_not_negative("c", values[0]);
                           const UnitNumbers numbers{.d = values[0]};
                           Case c = describe(numbers, values[1], values[2]);
                           c.equation =
                               fmt::format("x'' + c x' + x = 0, x(0) = {}, x'(0) = {}, c = {}",
                                           values[1], values[2], values[0]);
                           c.tags.emplace_back(numbers.d > 0 ? "damped" : "separable");
                           c.components = {"x", "v"};
                           c.stops = {1, 5, 10, 20};
                           c.settings.steps_multiple = 20;
                           c.settings.coarsest_steps = 80;
                           c.settings.finest_steps = 2560;
                           c.settings.evaluation_budget = 20'000;
                           if (values == Values{variant.damping, 1, 0.5})
                             c.truth = reference_truth(variant.reference, variant.floor);
                           if (numbers.d > 0)
                             set_problem(c, Oscillator<true, UnitNumbers>{numbers});
                           else
                             set_problem(c, Oscillator<false, UnitNumbers>{numbers});
                           return c;
                         });
}

/// The oscillator as a particle on a spring along x. The anchor is `length` before the equilibrium,
/// so far that the spring never passes zero length and its force is linear in x.
scene::Scene as_scene(const OscillatorNumbers& n, double y0, double v0, double length) {
  scene::Scene scene;
  scene.particles = {{.position = {n.rest - length, 0, 0}, .fixed = true},
                     {.position = {y0, 0, 0}, .velocity = {v0, 0, 0}, .mass = n.m}};
  scene.springs = {{.a = 0, .b = 1, .stiffness = n.k, .damping = n.d, .rest_length = length}};
  scene.select = {3, 9};
  return scene;
}

struct Variant {
  const char* id;
  const char* title;
  const char* equation;
  double d, rest, y0;
};

Case make_mass_on_spring(const Variant& variant, const Values& values) {
  const OscillatorNumbers n{values[0], values[1], values[2], values[3]};
  const double y0 = values[4], v0 = values[5];
  require_positive("m", n.m);
  require_not_negative("d", n.d);
  require_positive("k", n.k);
  Case c = describe(n, y0, v0);
  c.equation = variant.equation;
  if (values != Values{1, variant.d, 5, variant.rest, variant.y0, 0})
    c.equation = fmt::format("{} y'' + {} y' + {} (y - {}) = 0, y(0) = {}, y'(0) = {}", n.m, n.d,
                             n.k, n.rest, y0, v0);
  c.nature.smooth = true;
  if (!(n.d > 0)) c.tags.emplace_back("separable");
  c.components = {"y", "u"};
  c.stops = {5, 10};
  c.settings.steps_multiple = 2;
  c.settings.coarsest_steps = 40;
  c.settings.finest_steps = 40960;
  // The mass stays within this distance of the equilibrium: the energy does not grow.
  const double reach = std::hypot(y0 - n.rest, v0 * std::sqrt(n.m / n.k));
  const auto scene = std::make_shared<scene::Scene>(as_scene(n, y0, v0, 2 * std::max(reach, 1e-3)));
  if (n.d > 0)
    set_problem(c, Oscillator<true, OscillatorNumbers>{n}, scene);
  else
    set_problem(c, Oscillator<false, OscillatorNumbers>{n}, scene);
  return c;
}

Case make_variant(const Variant& variant) {
  return with_parameters(
      {{"m", 1, "mass, kg"},
       {"d", variant.d, "damping, N s/m"},
       {"k", 5, "stiffness, N/m"},
       {"rest", variant.rest, "position of the equilibrium, m"},
       {"y0", variant.y0, "position at the start, m"},
       {"u0", 0, "velocity at the start, m/s"}},
      [variant](const Values& values) { return make_mass_on_spring(variant, values); });
}

/// q'' = -2 zeta w q' - w^2 q with variable w and zeta, for the stability study.
template <bool Damped>
Probe probe() {
  using Problem = Oscillator<Damped, OscillatorNumbers>;
  return make_probe(Problem{}, {1, 0}, as_scene({.k = 1}, 1, 0, 1e3),
                    [](Problem& problem, scene::Scene& scene, double w, double zeta) {
                      problem.k = scene.springs[0].stiffness = w * w;
                      problem.d = scene.springs[0].damping = 2 * zeta * w;
                    });
}

const std::vector<std::string> common_tags{"second_order", "mechanical"};

Statement state(const UnitVariant& variant) {
  return {.id = variant.id, .title = variant.title, .tags = common_tags, .make = [variant] {
            return make_unit(variant);
          }};
}

/// With a plane for the stability study where `probe` is given.
Statement state(const Variant& variant, const std::string& plane = {}, Probe (*probe)() = nullptr) {
  return {.id = std::string("damped_oscillator_") + variant.id,
          .title = variant.title,
          .tags = common_tags,
          .make = [=] {
            Case c = make_variant(variant);
            c.plane = plane;
            if (probe) c.probe = probe;
            return c;
          }};
}

}  // namespace

/// Linear oscillators on both sides of critical damping, where the two roots coincide; and a mass
/// on a spring, which physics engines run too, in four kinds of damping and with a rest length in a
/// viscous fluid.
std::vector<Statement> oscillator() {
  return {
      state(Variant{"undamped", "Undamped oscillator", "y'' + 5 y = 0, y(0) = -5, y'(0) = 0", 0, 0,
                    -5},
            "undamped", probe<false>),
      state(Variant{"underdamped", "Underdamped oscillator",
                    "y'' + 0.5 y' + 5 y = 0, y(0) = -5, y'(0) = 0", 0.5, 0, -5},
            "oscillator", probe<true>),
      state(Variant{"critical", "Critically damped oscillator",
                    "y'' + 2 sqrt(5) y' + 5 y = 0, y(0) = -5, y'(0) = 0", 2 * std::sqrt(5.0), 0,
                    -5}),
      state(Variant{"overdamped", "Overdamped oscillator",
                    "y'' + 6 y' + 5 y = 0, y(0) = -5, y'(0) = 0", 6, 0, -5}),
      state(Variant{"rest_length", "Spring with a rest length in a viscous fluid",
                    "y'' = 5 (2 - y) - 0.5 y', y(0) = 3, y'(0) = 0", 0.5, 2, 3}),
      state(UnitVariant{"osc_undamped", "osc_undamped", "Oscillator, no damping", 0, 1e-25}),
      state(UnitVariant{"osc_under", "osc_under", "Oscillator, slight damping", 0.2, 2.5e-17}),
      state(UnitVariant{"osc_critical", "osc_critical", "Oscillator, critical damping", 2, 1e-25}),
      state(UnitVariant{"osc_nearly_critical", "osc_nearcrit_above_1e-6",
                        "Oscillator, a millionth above critical damping", 2.000002, 4e-17}),
      state(UnitVariant{"osc_over", "osc_over", "Oscillator, strong damping", 4, 1e-25})};
}

}  // namespace odeum::cases
