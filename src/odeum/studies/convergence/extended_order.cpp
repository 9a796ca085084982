// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/extended_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

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
      const Real unit = c.units.of(i, static_cast<double>(exact[i])),
                 error = (y[i] - exact[i]) / unit;
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

/// The order from runs about and beyond `rounding_steps`. None where the case or the solver has
/// nothing in extended precision, or long double is double.
std::optional<judge::OrderFit> extended_order(const Pair& pair, std::uint64_t rounding_steps) {
  const Case& c = *pair.c;
  if (!c.extended || !c.extended->truth || !pair.entrant->extended ||
      extended_half_unit >= std::numeric_limits<double>::epsilon() / 2)
    return std::nullopt;
  const double claimed = pair.entrant->info.order;
  // Seven numbers of steps, from before the rounding of double to a third beyond it, or to where
  // the error is a 500th of what rounding is in double: a quarter of what extended precision adds.
  const double far = std::pow(500, 1 / std::max(claimed, 2.0));
  judge::OrderFit fit;
  for (const auto& [from, to] : {std::pair{0.65, 1.35}, std::pair{0.9, far}}) {
    std::vector<judge::ErrorPoint> points;
    for (int k = 0; k < 7; ++k) {
      const double wanted =
          from * static_cast<double>(rounding_steps) * std::pow(to / from, k / 6.0);
      points.push_back(
          measure(c, pair.entrant->extended, nearest_multiple(wanted, c.settings.steps_multiple)));
    }
    fit = judge::fit_order(points, claimed, judge::fixed_step_tolerance(claimed));
    if (fit.verdict != judge::Verdict::undetermined) break;
  }
  return fit;
}

}  // namespace

void refit_in_extended_precision(const Pair& pair, std::uint64_t end_of_double,
                                 judge::OrderFit& fit) {
  if (fit.verdict != judge::Verdict::undetermined && fit.verdict != judge::Verdict::over_budget)
    return;
  std::optional<judge::OrderFit> closer = extended_order(pair, end_of_double);
  // There is no number where no run gave an error, or all of them are rounding.
  if (!closer || closer->verdict == judge::Verdict::undetermined || std::isnan(closer->order))
    return;
  closer->reason =
      fmt::format("order {:.2f} in extended precision, at steps of {:.2g} to {:.2g}; in double: {}",
                  closer->order, closer->step_coarsest, closer->step_finest, fit.reason);
  fit = *closer;
}

}  // namespace odeum::study
