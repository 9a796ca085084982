// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/study_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

namespace odeum::cases {

std::uint64_t steps_multiple(double t0, const std::vector<double>& stops) {
  const auto fits = [&](std::uint64_t steps) {
    return std::ranges::all_of(stops, [&](double stop) {
      const double at = (stop - t0) / (stops.back() - t0) * static_cast<double>(steps);
      return std::abs(at - std::round(at)) < 1e-9 && std::round(at) >= 1;
    });
  };
  // Equal distances may be more than that.
  if (fits(stops.size())) return stops.size();
  for (std::uint64_t steps = 1; steps <= 1000; ++steps)
    if (fits(steps)) return steps;
  return 0;
}

namespace {

/// The smallest number of steps, by doubling, with which a method of order 4 has an error below a
/// fiftieth of the solution; 0 where `most` are too few.
std::uint64_t enough_steps(const Case& c, const std::string& method, std::uint64_t most) {
  const Entrant* const solver = c.entrants.find("odeum/" + method);
  if (!solver || !solver->solve) return 0;
  const std::size_t n = c.y0.size();
  std::vector<double> exact(n);
  const auto is_close = [&](const Outcome& outcome) {
    double error = 0, size = 0;
    for (std::size_t stop = 0; stop < c.stops.size(); ++stop) {
      if (!c.truth.at(c.stops[stop], exact.data())) return false;
      for (std::size_t i = 0; i < n; ++i) {
        const double unit = c.units.of(i, exact[i]);
        const double difference = (outcome.states[stop * n + i] - exact[i]) / unit;
        error = std::max(error, std::abs(difference));  // a run that ended well is finite
        size = std::max(size, std::abs(exact[i]) / unit);
      }
    }
    return error <= 0.02 * size;
  };
  const std::uint64_t unit = c.settings.steps_multiple;
  for (std::uint64_t steps = unit * ((15 + unit) / unit); steps <= most; steps *= 2) {
    Request request{.steps = steps, .stops = c.stops};
    request.budget.evaluations = 10 * c.settings.evaluation_budget;
    const Outcome outcome = solver->solve(request);
    if (outcome.status == Status::ok && is_close(outcome)) return steps;
  }
  return 0;
}

/// The same for several methods: what the one of them needs that needs most; 0 where one has not
/// enough.
std::uint64_t enough_for_all(const Case& c, std::initializer_list<const char*> methods,
                             std::uint64_t most) {
  std::uint64_t largest = 0;
  for (const char* method : methods) {
    const std::uint64_t steps = enough_steps(c, method, most);
    if (steps == 0) return 0;
    largest = std::max(largest, steps);
  }
  return largest;
}

}  // namespace

void choose_steps(Case& c, bool smooth, bool known, std::uint64_t many) {
  StudySettings& s = c.settings;
  const std::uint64_t multiple = steps_multiple(c.t0, c.stops);
  if (multiple == 0) {
    s.no_fixed_steps = "no number of equal steps up to 1000 has every stop on a step";
    return;
  }
  s.steps_multiple = multiple;
  if (!known) return;
  constexpr std::uint64_t most = most_trial_steps;
  const std::uint64_t by_explicit = enough_steps(c, "rk4", most);
  // Newton's method may need smaller steps than the solution does.
  const std::uint64_t by_implicit =
      by_explicit == 0 || by_explicit > many
          ? enough_for_all(c, {"sdirk4", "radau_iia5", "rodas4"}, most / 4)
          : 0;
  if (by_explicit == 0 && by_implicit == 0) {
    s.no_fixed_steps = fmt::format(
        "{} equal steps of an explicit method of order 4, {} of implicit ones, leave more than 2 %",
        most, most / 4);
    s.evaluation_budget = 60'000;
    return;
  }
  if (by_implicit > 0 && (by_explicit == 0 || by_explicit > 8 * by_implicit)) {
    c.nature.stiff = true;
    s.coarsest_steps = by_implicit;
    s.finest_steps = 32 * by_implicit;
    s.evaluation_budget = 60'000;
    return;
  }
  s.coarsest_steps = by_explicit;
  s.finest_steps = std::clamp<std::uint64_t>(256 * by_explicit, 4096, 16 * most);
  s.evaluation_budget = std::max<std::uint64_t>(500'000, 10 * s.finest_steps);
  if (smooth) c.nature.smooth = true;
}

}  // namespace odeum::cases
