// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/problem/damped_oscillator.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/stage.hpp"
#include "odeum/scene/model/scene.hpp"

namespace odeum::cases {
namespace {

/// m y'' + d y' + k (y - rest) = 0. The undamped type has no damping term, so that methods for
/// separable systems fit it.
template <bool Damped>
struct Oscillator {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = Damped;
  double m = 1, d = 0, k = 5, rest = 0;

  template <class R>
  void acceleration(R, const R* q, const R* v, R* a) const {
    a[0] = -k / m * (q[0] - rest);
    if constexpr (Damped) a[0] -= d / m * v[0];
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
  void jacobian(double, const double*, double* j) const {
    j[0] = 0;
    j[1] = 1;
    j[2] = -k / m;
    j[3] = -d / m;
  }
  void linear_matrix(double* a) const { jacobian(0, nullptr, a); }
  double energy(const double* y) const {
    return m * y[1] * y[1] / 2 + k * (y[0] - rest) * (y[0] - rest) / 2;
  }
};

/// The oscillator as a particle on a spring along x. The anchor is `length` before the equilibrium,
/// so far that the spring never passes zero length and its force is linear in x.
scene::Scene as_scene(double m, double d, double k, double rest, double y0, double v0,
                      double length) {
  scene::Scene scene;
  scene.particles = {{.position = {rest - length, 0, 0}, .fixed = true},
                     {.position = {y0, 0, 0}, .velocity = {v0, 0, 0}, .mass = m}};
  scene.springs = {{.a = 0, .b = 1, .stiffness = k, .damping = d, .rest_length = length}};
  scene.select = {3, 9};
  return scene;
}

struct Variant {
  const char* id;
  const char* title;
  const char* equation;
  double d, rest, y0;
};

// m, d, k, rest, y0, v0, in the order of the parameters.
struct Numbers {
  double m, d, k, rest, y0, v0;
};

template <bool Damped>
Case make_case(const Variant& variant, const Numbers& numbers) {
  const auto [m, d, k, rest, y0, v0] = numbers;
  const Oscillator<Damped> problem{.m = m, .d = d, .k = k, .rest = rest};
  Case c;
  c.id = std::string("damped_oscillator_") + variant.id;
  c.title = variant.title;
  c.equation = variant.equation;
  c.source = "harmonic oscillator with viscous damping, any mechanics text";
  c.tags = {"linear", "autonomous", "second_order", "mechanical", "smooth"};
  if (!Damped) c.tags.emplace_back("separable");
  c.y0 = {y0, v0};
  c.components = {"y", "u"};
  c.stops = {5, 10};
  c.settings.steps_multiple = 2;
  c.settings.coarsest_steps = 40;
  c.settings.finest_steps = 40960;
  c.truth.source = "closed form";
  c.truth.at = [problem, y0 = y0, v0 = v0](double t, double* y) {
    damped_oscillator_solution(problem.m, problem.d, problem.k, y0 - problem.rest, v0, t, y);
    y[0] += problem.rest;
    return true;
  };
  // The mass stays within this distance of the equilibrium: the energy does not grow.
  const double reach = std::hypot(y0 - rest, v0 * std::sqrt(m / k));
  set_stage(
      c, problem,
      std::make_shared<scene::Scene>(as_scene(m, d, k, rest, y0, v0, 2 * std::max(reach, 1e-3))));
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
      [variant](const Values& values) {
        const Numbers x{values[0], values[1], values[2], values[3], values[4], values[5]};
        require_positive("m", x.m);
        require_not_negative("d", x.d);
        require_positive("k", x.k);
        Case c = x.d > 0 ? make_case<true>(variant, x) : make_case<false>(variant, x);
        if (values != Values{1, variant.d, 5, variant.rest, variant.y0, 0})
          c.equation = fmt::format("{} y'' + {} y' + {} (y - {}) = 0, y(0) = {}, y'(0) = {}", x.m,
                                   x.d, x.k, x.rest, x.y0, x.v0);
        return c;
      });
}

/// q'' = -2 zeta w q' - w^2 q with variable w and zeta, for the stability study.
template <bool Damped>
Probe probe() {
  return make_probe(Oscillator<Damped>{}, {1, 0}, as_scene(1, 0, 1, 0, 1, 0, 1e3),
                    [](Oscillator<Damped>& problem, scene::Scene& scene, double w, double zeta) {
                      problem.k = scene.springs[0].stiffness = w * w;
                      problem.d = scene.springs[0].damping = 2 * zeta * w;
                    });
}

}  // namespace

/// A mass on a spring in four kinds of damping, and one with a rest length in a viscous fluid.
std::vector<Case> damped_oscillator() {
  Case undamped = make_variant(
      {"undamped", "Undamped oscillator", "y'' + 5 y = 0, y(0) = -5, y'(0) = 0", 0, 0, -5});
  undamped.plane = "undamped";
  undamped.probe = probe<false>;
  Case under = make_variant({"underdamped", "Underdamped oscillator",
                             "y'' + 0.5 y' + 5 y = 0, y(0) = -5, y'(0) = 0", 0.5, 0, -5});
  under.plane = "oscillator";
  under.probe = probe<true>;
  return {undamped, under,
          make_variant({"critical", "Critically damped oscillator",
                        "y'' + 2 sqrt(5) y' + 5 y = 0, y(0) = -5, y'(0) = 0", 2 * std::sqrt(5.0), 0,
                        -5}),
          make_variant({"overdamped", "Overdamped oscillator",
                        "y'' + 6 y' + 5 y = 0, y(0) = -5, y'(0) = 0", 6, 0, -5}),
          make_variant({"rest_length", "Spring with a rest length in a viscous fluid",
                        "x'' = 5 (2 - x) - 0.5 x', x(0) = 3, x'(0) = 0", 0.5, 2, 3})};
}

}  // namespace odeum::cases
