// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/step_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>

#include "odeum/linear/eigenvalues.hpp"

namespace odeum::judge {
namespace {

using Vector = std::vector<double>;

Vector product(const Vector& a, const Vector& b, std::size_t n) {
  Vector ab(n * n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t j = 0; j < n; ++j) ab[i * n + j] += a[i * n + k] * b[k * n + j];
  return ab;
}

double largest(const Vector& x) {
  double size = 0;
  for (const double value : x) size = std::max(size, std::abs(value));
  return size;
}

/// The state after `steps` steps from y.
Vector state_after(const Case& c, const Solver& solver, double h, std::uint64_t steps,
                   const Vector& y) {
  ErasedContest contest = c.problem;
  contest.y0 = std::make_shared<const Vector>(y);
  Entrant entrant{.info = solver.info, .unfit = {}, .solve = {}};
  solver.enroll(contest, entrant);
  if (!entrant.unfit.empty()) throw std::runtime_error(entrant.unfit);
  Request request;
  request.steps = steps;
  request.stops = {c.t0 + static_cast<double>(steps) * h};
  Outcome outcome = entrant.solve(request);
  if (outcome.status != Status::ok)
    throw std::runtime_error(fmt::format("{} in {} steps of {}: {}", to_string(outcome.status),
                                         steps, h, outcome.detail));
  return std::move(outcome.states);
}

}  // namespace

Powers powers_of(const Vector& matrix, std::size_t n) {
  Powers powers{.eigenvalues = eigenvalues(matrix, n), .radius = 0, .polynomial = 0};
  for (const auto& z : powers.eigenvalues) powers.radius = std::max(powers.radius, std::abs(z));
  // Multiple eigenvalues are computed to a root of rounding, hence the powers themselves.
  constexpr double near_one = 1e-3;
  if (std::abs(powers.radius - 1) > near_one) return powers;
  constexpr int first = 10, second = 16, last = 20;  // doublings
  std::vector<Vector> doubled{matrix};
  for (int k = 1; k <= last; ++k) doubled.push_back(product(doubled.back(), doubled.back(), n));
  // The largest entry after about 2^k steps, whatever the phase of a rotation.
  const auto size = [&](std::size_t k) {
    double most = largest(doubled[k]);
    for (std::size_t more = 1; more <= 8; ++more)
      most = std::max(most, largest(product(doubled[k], doubled[k - more], n)));
    return std::log2(most);
  };
  const double early = (size(second) - size(first)) / (second - first),
               late = (size(last) - size(second)) / (last - second);
  constexpr double apart = 0.3;  // of a power of n; other growth is faster and faster
  const bool steady = std::isfinite(late) && std::abs(early - late) < apart &&
                      std::abs(late - std::round(late)) < apart;
  if (steady && late > 0.5) powers.polynomial = static_cast<int>(std::lround(late));
  constexpr double rounding = 1e-13;
  if (powers.polynomial > 0 || std::abs(powers.radius - 1) < rounding) powers.radius = 1;
  return powers;
}

StepMatrix measure_step_matrix(const Case& c, const Solver& solver, double h) {
  const std::size_t n = c.y0.size();
  StepMatrix step{.matrix = Vector(n * n),
                  .vector = state_after(c, solver, h, 1, Vector(n)),
                  .powers = {},
                  .rest = 0};
  for (std::size_t j = 0; j < n; ++j) {
    Vector unit(n);
    unit[j] = 1;
    const Vector column = state_after(c, solver, h, 1, unit);
    for (std::size_t i = 0; i < n; ++i) step.matrix[i * n + j] = column[i] - step.vector[i];
  }
  step.powers = powers_of(step.matrix, n);
  constexpr int steps = 8;
  const Vector from_zero = state_after(c, solver, h, steps, Vector(n)),
               from_start = state_after(c, solver, h, steps, c.y0);
  Vector expected = c.y0;
  for (int k = 0; k < steps; ++k) {
    Vector next(n);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) next[i] += step.matrix[i * n + j] * expected[j];
    expected = next;
  }
  for (std::size_t i = 0; i < n; ++i) expected[i] -= from_start[i] - from_zero[i];
  const double size = std::max({largest(c.y0), largest(from_start), largest(from_zero)});
  step.rest = size > 0 ? largest(expected) / size : 0;
  return step;
}

std::string text_of_radius(double radius) {
  constexpr double near_one = 1e-6;  // whose distance from 1 is what tells
  const double off = radius - 1;
  if (off == 0 || std::abs(off) > near_one) return fmt::format("{:.10g}", radius);
  return fmt::format("1 {} {:.3g}", off < 0 ? '-' : '+', std::abs(off));
}

std::string consequence(const Powers& powers, double steps) {
  if (powers.polynomial > 1) return fmt::format("grows as n^{}", powers.polynomial);
  if (powers.polynomial == 1) return "grows as n";
  if (powers.radius == 1) return "stays bounded";
  const std::string radius = text_of_radius(powers.radius);
  return fmt::format("{} as {}^n: by a factor of {:.6g} in {:.6g} steps",
                     powers.radius > 1 ? "diverges" : "decays",
                     radius.find(' ') == std::string::npos ? radius : "(" + radius + ")",
                     std::pow(powers.radius, steps), steps);
}

}  // namespace odeum::judge
