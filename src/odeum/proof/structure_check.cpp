// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/structure_check.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "odeum/proof/test_problems.hpp"

namespace odeum::proof {
namespace {

using Vec4 = std::array<double, 4>;

// q'' = -grad U, U = (q1^2 + q2^2)/2 + q1^2 q2 - q2^3/3 (Henon, Heiles 1964).
FunctionMechanics<false> henon_heiles() {
  const auto a = [](double, const double* q, const double*, double* out) {
    out[0] = -q[0] - 2 * q[0] * q[1];
    out[1] = -q[1] - q[0] * q[0] + q[1] * q[1];
  };
  const auto a_q = [](double, const double* q, const double*, double* out) {
    out[0] = -1 - 2 * q[1];
    out[1] = out[2] = -2 * q[0];
    out[3] = -1 + 2 * q[1];
  };
  return mechanics<false>(2, {.a = a, .a_q = a_q});
}

double energy_of(const std::vector<double>& y) {
  return (y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3]) / 2 + y[0] * y[0] * y[1] -
         y[1] * y[1] * y[1] / 3;
}

constexpr std::array<Vec4, 3> states{
    {{0.4, -0.25, 0.3, 0.35}, {-0.3, 0.35, -0.45, 0.1}, {0.1, 0.5, 0.2, -0.3}}};

bool one_step(AnyStepper& stepper, double t, double h, std::vector<double>& y) {
  stepper.start(t, h, y);
  return stepper.step(t, h, y) == Status::ok;
}

// Column k of the Jacobian of a step: central differences of order 8.
bool column(AnyStepper& stepper, double h, const Vec4& state, std::size_t k, Vec4& slope) {
  constexpr std::array<double, 4> weights{4. / 5, -1. / 5, 4. / 105, -1. / 280};
  constexpr double spacing = 0.05;
  slope = {};
  for (std::size_t m = 0; m < weights.size(); ++m)
    for (const int sign : {1, -1}) {
      std::vector<double> y(state.begin(), state.end());
      y[k] += sign * spacing * static_cast<double>(m + 1);
      if (!one_step(stepper, 0, h, y)) return false;
      for (std::size_t i = 0; i < 4; ++i) slope[i] += sign * weights[m] / spacing * y[i];
    }
  return true;
}

// dp_1 dq_1 + dp_2 dq_2 antisymmetrised
double form(const Vec4& x, const Vec4& y) {
  return x[0] * y[2] - x[2] * y[0] + x[1] * y[3] - x[3] * y[1];
}

double larger(double x, double y) { return std::isnan(y) ? y : std::isnan(x) ? x : std::max(x, y); }

double returned(AnyStepper& stepper, double t, double h, const std::vector<double>& from) {
  std::vector<double> y = from;
  if (!one_step(stepper, t, h, y) || !one_step(stepper, t + h, -h, y)) return nan;
  double worst = 0;
  for (std::size_t i = 0; i < y.size(); ++i) worst = larger(worst, std::abs(y[i] - from[i]));
  return worst;
}

}  // namespace

double symplectic_defect(const MechanicsMaker& make, double h) {
  const FunctionMechanics<false> problem = henon_heiles();
  const auto stepper = make(problem);
  double worst = 0;
  for (const Vec4& state : states) {
    std::array<Vec4, 4> j{};
    for (std::size_t k = 0; k < 4; ++k)
      if (!column(*stepper, h, state, k, j[k])) return nan;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t l = 0; l < k; ++l)
        worst = larger(worst, std::abs(form(j[l], j[k]) - (k == l + 2 ? 1.0 : 0.0)));
  }
  return worst;
}

double return_defect(const MechanicsMaker& make, double h) {
  const FunctionMechanics<false> problem = henon_heiles();
  const auto stepper = make(problem);
  double worst = 0;
  for (const Vec4& state : states)
    worst = larger(worst, returned(*stepper, 0, h, {state.begin(), state.end()}));
  const auto& driven = separable_test_problems().back();
  const auto on_driven = make(driven.problem);
  return larger(worst, returned(*on_driven, driven.t0, h, driven.y0));
}

EnergyWatch watch_energy(const MechanicsMaker& make, int steps_per_period, double periods) {
  const FunctionMechanics<false> problem = henon_heiles();
  const auto stepper = make(problem);
  std::vector<double> y{0.2, -0.1, 0.15, 0.2};  // a fifth of the energy of escape: a regular orbit
  const double start = energy_of(y), h = 2 * std::numbers::pi / steps_per_period;
  const auto steps = static_cast<std::uint64_t>(periods * steps_per_period);
  EnergyWatch watch;
  stepper->start(0, h, y);
  for (std::uint64_t i = 0; i < steps; ++i) {
    if (stepper->step(static_cast<double>(i) * h, h, y) != Status::ok) return {nan, nan};
    const double error = std::abs(energy_of(y) / start - 1);
    if (i < steps / 10) watch.first = larger(watch.first, error);
    if (i >= steps - steps / 10) watch.last = larger(watch.last, error);
  }
  return watch;
}

}  // namespace odeum::proof
