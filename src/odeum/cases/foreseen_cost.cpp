// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/foreseen_cost.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "odeum/solvers/own_methods.hpp"
#include "odeum/solvers/pieces.hpp"

namespace odeum::cases {
namespace {

/// Seconds as people say them, to one digit or two.
std::string duration(double seconds) {
  constexpr double minute = 60, hour = 3600, day = 86400;
  const auto in = [&](double unit, const char* name) {
    return fmt::format("{:.2g} {}", seconds / unit, name);
  };
  if (seconds < 2 * minute) return in(1, "s");
  if (seconds < 2 * hour) return in(minute, "minutes");
  if (seconds < 2 * day) return in(hour, "hours");
  return seconds < 100 * day ? in(day, "days") : "months";
}

}  // namespace

void foresee_cost(const Case& c, truth::Reference& reference) {
  constexpr double tolerance = 1e-6, share = 0.2;
  if (!std::isfinite(reference.spent_at) || !(reference.spent_at > c.t0)) return;
  const auto say = [&](double times, const std::string& since) {
    reference.end += fmt::format(
        "; to the end it would take about {}, since {} up to t = {:.4g}, as far as "
        "{:.2g} s went",
        duration(times * reference.seconds), since, reference.spent_at, reference.seconds);
  };
  const double way = reference.spent_at - c.t0, whole = c.stops.back() - c.t0;
  if (reference.is_explicit)
    return say(whole / way, fmt::format("{:.2g} of the time {:.4g} lies", way / whole, whole));
  const Entrant entrant = enrolled(own_solver("bdf_variable"), c.problem);
  const auto steps_to = [&](double t) -> std::uint64_t {
    Request request;
    request.mode = Mode::adaptive;
    set_tolerance(request, c, tolerance);
    request.stops = {t};
    request.budget.seconds = std::max(1.0, share * reference.seconds);
    const Outcome outcome = entrant.solve(request);
    return outcome.status == Status::ok ? outcome.counters.steps : 0;
  };
  const std::uint64_t before = steps_to(reference.spent_at);
  const std::uint64_t all = before > 0 ? steps_to(c.stops.back()) : 0;
  if (all > before)
    say(static_cast<double>(all) / static_cast<double>(before),
        fmt::format("bdf_variable takes {} of {} steps", before, all));
}

}  // namespace odeum::cases
