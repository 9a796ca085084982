// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "odeum/studies/drift/drift.hpp"

namespace odeum::study {
namespace {

/// Whether the truth's energy is constant at all of its stops. A truth is rounded to double, which
/// changes an energy by some 1e-13 at most; weak damping changes it by 1e-3 and more.
bool keeps_energy(const Case& c) {
  constexpr double allowed = 1e-9;
  const double start = c.energy(c.y0.data());
  std::vector<double> exact(c.y0.size());
  bool known = false;
  for (const double stop : c.stops) {
    if (!c.truth.at(stop, exact.data())) continue;
    known = true;
    if (!(std::abs(c.energy(exact.data()) - start) <= allowed * std::abs(start))) return false;
  }
  return known;
}

}  // namespace

std::vector<Invariant> kept_quantities(const Case& c) {
  std::vector<Invariant> kept = c.invariants;
  if (c.energy && keeps_energy(c)) kept.insert(kept.begin(), {"energy", c.energy});
  return kept;
}

double HarmonicMotion::amplitude_of(const double* y) const {
  return std::hypot(y[0], y[1] / omega);
}

double HarmonicMotion::lag_of(const double* y, double elapsed, double expected) const {
  // The angle runs clockwise from q towards -q'.
  const double exact = start + omega * elapsed;
  const double lag = exact - std::atan2(-y[1] / omega, y[0]);
  constexpr double turn = 2 * std::numbers::pi;
  return lag - turn * std::round((lag - expected) / turn);
}

std::optional<HarmonicMotion> harmonic_motion(const Case& c) {
  const OdeView& view = c.problem.view;
  if (!view.linear_matrix || view.degrees_of_freedom != 1) return std::nullopt;
  double matrix[4], rest[2];
  view.linear_matrix(view.problem, matrix);
  const double origin[2] = {0, 0};
  view.rhs(view.problem, c.t0, origin, rest);
  const bool harmonic = matrix[2] < 0 && matrix[3] == 0 && rest[0] == 0 && rest[1] == 0;
  if (!harmonic) return std::nullopt;
  HarmonicMotion motion{.omega = std::sqrt(-matrix[2])};
  motion.amplitude = motion.amplitude_of(c.y0.data());
  motion.start = std::atan2(-c.y0[1] / motion.omega, c.y0[0]);
  return motion;
}

}  // namespace odeum::study
