// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "odeum/studies/material/material.hpp"

namespace odeum::study {
namespace {

/// Samples below this fraction of the first one are ignored: rounding, and slow parts of other
/// modes.
constexpr double least_part = 1e-4;

/// Least squares in three unknowns by modified Gram and Schmidt; rows are {1, y, x, right side}.
std::array<long double, 3> least_squares(std::vector<std::array<long double, 4>> rows) {
  std::array<std::array<long double, 4>, 3> r{};
  for (std::size_t i = 0; i < 3; ++i) {
    long double norm = 0;
    for (const auto& row : rows) norm += row[i] * row[i];
    norm = std::sqrt(norm);
    for (auto& row : rows) row[i] /= norm;
    r[i][i] = norm;
    for (std::size_t j = i + 1; j < 4; ++j) {
      for (const auto& row : rows) r[i][j] += row[i] * row[j];
      for (auto& row : rows) row[j] -= r[i][j] * row[i];
    }
  }
  std::array<long double, 3> x{};
  for (std::size_t i = 3; i-- > 0;) {
    x[i] = r[i][3];
    for (std::size_t j = i + 1; j < 3; ++j) x[i] -= r[i][j] * x[j];
    x[i] /= r[i][i];
  }
  return x;
}

}  // namespace

Vibration fit_vibration(const std::vector<double>& z, double step) {
  const double start = std::abs(z.front());
  std::size_t end = z.size();
  while (end > 1 && std::abs(z[end - 1]) < least_part * start) --end;
  // From rest, a cosine falls to 1/e after 1.2 radians: half of that stays well below half a turn.
  std::size_t fallen = 1;
  while (fallen + 1 < end && z[fallen] / z.front() > std::exp(-1)) ++fallen;
  const std::size_t lag = std::max<std::size_t>(1, fallen / 2);
  if (end < 2 * lag + 4)
    return {.reason = end <= 2   ? "decays within a step"
                      : end < 20 ? fmt::format("decays within {} steps, too few for a fit", end - 1)
                                 : "too slow for this time"};
  std::vector<std::array<long double, 4>> rows;
  for (std::size_t j = lag; j + lag < end; ++j) rows.push_back({1, z[j - lag], z[j], z[j + lag]});
  const auto [c, b, a] = least_squares(std::move(rows));
  const long double tau = static_cast<long double>(lag) * step, d = a * a + 4 * b;
  Vibration found;
  if (d < 0) {
    const long double fall = std::log(-b) / 2, turn = std::atan2(std::sqrt(-d), a);
    found.omega_squared = static_cast<double>((fall * fall + turn * turn) / (tau * tau));
    found.decay = static_cast<double>(-2 * fall / tau);
  } else {
    const long double fast = (a - std::sqrt(d)) / 2, slow = (a + std::sqrt(d)) / 2;
    // A root of the size of rounding is a motion that a single step removes.
    if (!(fast > 1e-9L && slow > 0))
      return {.reason = slow > 0 && std::abs(fast) <= 1e-9L
                            ? "overdamped, its velocity is lost at each step"
                            : "changes sign from step to step, unlike an oscillator"};
    found.omega_squared = static_cast<double>(std::log(fast) * std::log(slow) / (tau * tau));
    found.decay = static_cast<double>(-(std::log(fast) + std::log(slow)) / tau);
  }
  if (!std::isfinite(found.omega_squared) || !std::isfinite(found.decay))
    found.reason = "no oscillator fits the motion";
  return found;
}

}  // namespace odeum::study
