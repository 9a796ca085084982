// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/element_case.hpp"
#include "odeum/fem/shapes.hpp"

namespace odeum::cases {
namespace {

using System = std::shared_ptr<const fem::SemiDiscrete>;

/// The coordinates of a state in the modes: phi^T M u.
std::vector<long double> in_modes(const fem::SemiDiscrete& system, const std::vector<double>& u) {
  std::vector<long double> product(u.size());
  for (int i = 0; i < system.mass.rows; ++i)
    for (int k = system.mass.start[i]; k < system.mass.start[i + 1]; ++k)
      product[i] += static_cast<long double>(system.mass.value[k]) * u[system.mass.column[k]];
  return system.modes->coordinates(product);
}

/// Sets out[i] to the sum of amplitude(k) phi_k.
template <class Amplitude>
void combine(const linear::Modes& modes, const Amplitude& amplitude, double* out) {
  const std::size_t n = modes.values.size();
  std::vector<long double> sum(n);
  for (std::size_t k = 0; k < n; ++k) {
    const long double a = amplitude(k);
    for (std::size_t i = 0; i < n; ++i) sum[i] += a * modes.vectors[k][i];
  }
  for (std::size_t i = 0; i < n; ++i) out[i] = static_cast<double>(sum[i]);
}

constexpr std::size_t divisions = 8;

System make_system(fem::Mass mass, double load) {
  const fem::EllipticProblem problem{.load = [load](fem::Point) { return load; }};
  return std::make_shared<const fem::SemiDiscrete>(
      fem::semi_discrete(fem::unit_square(divisions), problem, mass));
}

std::vector<double> at_nodes(const fem::SemiDiscrete& system,
                             const std::function<double(fem::Point)>& value) {
  std::vector<double> u;
  for (const fem::Point p : system.nodes) u.push_back(value(p));
  return u;
}

Case common(const char* mass, const System& system) {
  Case c;
  c.nature.linear = c.nature.stiff = true;
  c.source = fmt::format(
      "linear elements on 2 x {0} x {0} right triangles of the unit square, {1} mass, u = 0 on the "
      "boundary (Thomee, Galerkin Finite Element Methods for Parabolic Problems, chapters 1 and "
      "15)",
      divisions, mass);
  c.settings.steps_multiple = 4;
  c.settings.finest_steps = 1024;
  c.settings.evaluation_budget = 20'000;
  c.truth.source = fmt::format(
      "closed form: the {} modes of K phi = value M phi, in extended "
      "precision",
      system->size());
  c.truth.closed_form = true;
  return c;
}

Case heat(const char* mass, const System& system, double load, const char* start,
          std::vector<double> u0, double horizon) {
  Case c = common(mass, system);
  c.equation = fmt::format("M u' = -K u + f, f = {}, u(0) = {}", load, start);
  c.y0 = std::move(u0);
  c.stops = {horizon / 4, horizon / 2, horizon};
  // The largest eigenvalue times the horizon is 51 and 62: the first count is stable for rk4.
  c.settings.coarsest_steps = 32;
  c.truth.at = [system, a = in_modes(*system, c.y0),
                f = system->modes->coordinates({system->load.begin(), system->load.end()})](
                   double t, double* y) {
    combine(
        *system->modes,
        [&](std::size_t k) {
          const long double decay = -system->modes->values[k] * t;
          return std::exp(decay) * a[k] - std::expm1(decay) / system->modes->values[k] * f[k];
        },
        y);
    return true;
  };
  // Rounding of M^-1 K in double where M is consistent: 1e-16 of its norm of 1500, times 0.04.
  c.truth.floor = 1e-14;
  set_heat_stage(c, system);
  return c;
}

Case wave(const char* mass, const System& system) {
  Case c = common(mass, system);
  c.equation = "M u'' = -K u, u(0) = 16 x (1 - x) y (1 - y) at rest";
  const std::size_t n = system->size();
  c.y0 = at_nodes(*system, [](fem::Point p) { return 16 * p.x * (1 - p.x) * p.y * (1 - p.y); });
  c.truth.at = [system, a = in_modes(*system, c.y0), n](double t, double* y) {
    const auto& values = system->modes->values;
    combine(
        *system->modes, [&](std::size_t k) { return a[k] * std::cos(std::sqrt(values[k]) * t); },
        y);
    combine(
        *system->modes,
        [&](std::size_t k) {
          return -a[k] * std::sqrt(values[k]) * std::sin(std::sqrt(values[k]) * t);
        },
        y + n);
    return true;
  };
  // As above; the lowest frequency of 4.4 is off by 1e-16 * 1500 / (2 * 4.4), for a time of 1.
  c.truth.floor = 1e-13;
  c.y0.resize(2 * n);
  c.stops = {0.25, 0.5, 1};
  c.settings.coarsest_steps = 32;
  set_wave_stage(c, system);
  return c;
}

double peak(fem::Point p) {
  return std::exp(p.x - p.y) * std::sin(std::numbers::pi * p.x) *
         std::sin(2 * std::numbers::pi * p.y);
}
double corner(fem::Point p) { return p.x < 0.5 && p.y < 0.5 ? 1. : 0.; }

Statement state(const char* id, const char* title, bool parabolic, std::function<Case()> make) {
  Statement statement{
      .id = id, .title = title, .tags = {"finite_elements"}, .make = std::move(make)};
  for (const char* tag : {"second_order", "separable", "hyperbolic", "oscillatory"})
    if (!parabolic) statement.tags.emplace_back(tag);
  if (parabolic) statement.tags.emplace_back("parabolic");
  return statement;
}

}  // namespace

/// Heat and waves on the unit square by linear finite elements: smooth and discontinuous initial
/// values, lumped and consistent mass.
std::vector<Statement> finite_elements() {
  return {state("fem_heat", "Heat equation by finite elements", true,
                [] {
                  const auto system = make_system(fem::Mass::lumped, 1);
                  return heat("lumped", system, 1, "exp(x - y) sin(pi x) sin(2 pi y)",
                              at_nodes(*system, peak), 0.1);
                }),
          state("fem_heat_rough", "Heat equation with a jump in its initial values", true,
                [] {
                  const auto system = make_system(fem::Mass::consistent, 0);
                  return heat("consistent", system, 0, "1 where x, y < 1/2, else 0",
                              at_nodes(*system, corner), 0.04);
                }),
          state("fem_wave", "Wave equation by finite elements", false,
                [] { return wave("lumped", make_system(fem::Mass::lumped, 0)); }),
          state("fem_wave_consistent", "Wave equation with a consistent mass matrix", false,
                [] { return wave("consistent", make_system(fem::Mass::consistent, 0)); })};
}

}  // namespace odeum::cases
