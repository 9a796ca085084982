// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/extended_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/core/numbers.hpp"
#include "odeum/judge/errors.hpp"

namespace odeum::study {
namespace {

using Real = ExtendedProblem::real;
constexpr double extended_half_unit = std::numeric_limits<Real>::epsilon() / 2;

/// The error as in Judge, in extended precision: the root mean square over components and stops.
judge::ErrorPoint measure(const Case& c, const ExtendedRun& run, std::uint64_t steps) {
  const ExtendedProblem& problem = *c.extended;
  const std::vector<std::size_t> measured = judge::measured_components(c);
  const std::vector<Real> states = run(problem, c.t0, c.stops, steps);
  const auto numbers = static_cast<Real>(measured.size());
  std::vector<Real> exact(problem.size());
  Real squares = 0, largest = 0;
  for (std::size_t stop = 0; stop < c.stops.size(); ++stop) {
    const Real* const y = states.data() + stop * problem.size();
    Real size = 0;
    if (!problem.truth(c.stops[stop], exact.data())) return {.error = nan};
    for (const std::size_t i : measured) {
      const Real unit = c.scale_of(i), error = (y[i] - exact[i]) / unit;
      squares += error * error;
      size += exact[i] / unit * (exact[i] / unit);
    }
    largest = std::max(largest, std::sqrt(size / numbers));
  }
  const auto n = static_cast<double>(steps);
  return {.step = (c.stops.back() - c.t0) / n,
          .error =
              static_cast<double>(std::sqrt(squares / numbers / static_cast<Real>(c.stops.size()))),
          .steps = n,
          .rounding_unit = extended_half_unit * static_cast<double>(largest),
          .floor = problem.floor,
          .scale = static_cast<double>(largest),
          .components = static_cast<double>(numbers)};
}

}  // namespace

std::optional<judge::OrderFit> extended_order(const Pair& pair, std::uint64_t rounding_steps) {
  const Case& c = *pair.c;
  if (!c.extended || !c.extended->truth || !pair.entrant->extended ||
      extended_half_unit >= std::numeric_limits<double>::epsilon() / 2)
    return std::nullopt;
  // Seven numbers of steps, from before the rounding of double to a third beyond it.
  std::vector<judge::ErrorPoint> points;
  for (int k = 0; k < 7; ++k) {
    const double wanted = 0.65 * static_cast<double>(rounding_steps) * std::pow(1.13, k);
    const auto units = std::llround(wanted / static_cast<double>(c.settings.steps_multiple));
    points.push_back(
        measure(c, pair.entrant->extended,
                c.settings.steps_multiple * static_cast<std::uint64_t>(std::max(units, 1LL))));
  }
  const double claimed = pair.entrant->info.order;
  return judge::fit_order(points, claimed, judge::fixed_step_tolerance(claimed));
}

}  // namespace odeum::study
