// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/advise/limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "odeum/advise/answer_parts.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/judge/flow.hpp"
#include "odeum/measure/local.hpp"

namespace odeum::advise {
namespace {

using measure::Moment, measure::Region, measure::Run, measure::Spectrum;

using State = std::vector<double>;

/// The largest part of the stable range that a step of h takes at a state; NaN: no edge is known.
double used_at(const Case& c, Region& region, double t, double h, const State& y) {
  const Spectrum spectrum = measure::spectrum_at(c, t, y, State(y.size(), 1), true);
  double used = spectrum.all.empty() ? nan : 0;
  for (const std::complex<double>& z : spectrum.all) {
    // A motion that grows by itself has no edge.
    if (z == 0.0 || z.real() > 1e-6 * std::abs(z)) continue;
    const double edge = region.edge(z);
    if (std::isnan(edge)) return nan;
    used = std::max(used, h * std::abs(z) / edge);
  }
  return used;
}

/// The same, largest at the start and at some of the stops.
double used_by_fixed_step(const Case& c, Region& region, double h) {
  constexpr std::size_t most = 8;
  double used = used_at(c, region, c.t0, h, c.y0);
  State y(c.y0.size());
  const std::size_t apart = 1 + c.stops.size() / most;
  for (std::size_t k = c.stops.size(); k > 0; k -= std::min(k, apart))
    if (c.truth.at(c.stops[k - 1], y.data()))
      used = std::max(used, used_at(c, region, c.stops[k - 1], h, y));
  return used;
}

/// The finest run that is coarser than the winner's and misses the error; null: none was made.
const Trial* nearest_miss(const Advice& advice) {
  const Candidate& winner = winner_of(advice);
  const Trial* nearest = advice.coarser ? &*advice.coarser : nullptr;
  for (const Trial& trial : winner.trials)
    if (nearest && trial.fineness < winner.found->fineness && trial.fineness > nearest->fineness &&
        trial.status != Status::over_budget && !trial.reaches(advice.wishes.error))
      nearest = &trial;
  return nearest;
}

std::string limit_of_fixed(const Advice& advice, const Case& c) {
  const Candidate& winner = winner_of(advice);
  const Trial* const coarser = nearest_miss(advice);
  if (!coarser) return advice.frames > 0 ? "frame" : "stops: no fewer steps end on them";
  const Trial& found = *winner.found;
  // Four times what the order explains.
  const double ratio = found.fineness / coarser->fineness;
  if (coarser->status == Status::ok &&
      coarser->error <= 4 * std::pow(ratio, winner.slope()) * found.error)
    return "accuracy";
  Region region(winner.entrant->info.id());
  const double used = used_by_fixed_step(c, region, step_of(coarser->request(), c.t0));
  if (std::isnan(used))
    return "unknown: the coarser step has more error than its order explains, and no edge of "
           "stability is known";
  return used > 1 ? "stability" : "accuracy";
}

std::string limit_of_adaptive(const Advice& advice, const Case& c) {
  if (!advice.coarser) return "unknown: no tolerance is looser";
  const Candidate& winner = winner_of(advice);
  const Trial &found = *winner.found, &coarser = *advice.coarser;
  const auto steps = [](const Trial& trial) {
    return static_cast<double>(trial.counters().steps + trial.counters().rejected_steps);
  };
  // A pair of order 20 would save a tenth of its steps.
  if (coarser.status == Status::ok && steps(coarser) <= 0.9 * steps(found)) return "accuracy";
  constexpr std::size_t moments = 16;
  constexpr double near_edge = 0.6;
  Region region(winner.entrant->info.id());
  const Run run = measure::record(c, winner.entrant->info.id(), found.request(), moments);
  std::size_t known = 0, near = 0;
  for (const Moment& at : run.moments) {
    const double used = at.h > 0 ? used_at(c, region, at.t, at.h, at.y) : nan;
    if (std::isnan(used)) continue;
    ++known;
    if (used > near_edge) ++near;
  }
  if (2 * near > known) return "stability";
  if (coarser.status != Status::ok)
    return fmt::format("unknown: to ten times the tolerance the run ends {}",
                       to_string(coarser.status));
  const bool misses = !coarser.reaches(advice.wishes.error);
  return fmt::format(
      "{}: ten times the tolerance takes {:g} steps in place of {:g}{}{}",
      misses ? "accuracy" : "unknown", steps(coarser), steps(found),
      misses ? fmt::format(" and has {:.2g} times the error", coarser.error / found.error) : "",
      known > 0 ? ", and no eigenvalue is near the edge of stability" : "");
}

/// Changes of the start, each of a millionth of the components' sizes.
std::vector<State> changed_starts(const Case& c) {
  constexpr double change = 1e-6;
  constexpr std::size_t few = 8, draws = 4;
  const std::size_t n = c.y0.size();
  std::vector<State> starts;
  std::mt19937 random(1);
  for (std::size_t k = 0; k < (n <= few ? n : draws); ++k) {
    State y = c.y0;
    for (std::size_t i = 0; i < n; ++i) {
      const double size = change * (c.scale_of(i) + std::abs(y[i]));
      if (n > few)
        y[i] += random() % 2 ? size : -size;
      else if (i == k)
        y[i] += size;
    }
    starts.push_back(std::move(y));
  }
  return starts;
}

/// The largest difference of a measured component at each stop over that at the start, both in
/// units of its scale.
void take_growth(const Case& c, const State& start, const State& from, const State& moved,
                 State& growth) {
  const std::size_t n = c.y0.size();
  double at_start = 0;
  for (std::size_t i = 0; i < n; ++i)
    at_start = std::max(at_start, std::abs(start[i] - c.y0[i]) / c.scale_of(i));
  for (std::size_t stop = 0; stop < growth.size(); ++stop)
    for (const std::size_t i : judge::measured_components(c)) {
      const std::size_t at = stop * n + i;
      growth[stop] =
          std::max(growth[stop], std::abs(moved[at] - from[at]) / c.scale_of(i) / at_start);
    }
}

/// How many of the stops the states are near the truth at.
std::size_t stops_followed(const Case& c, const State& states) {
  const judge::Judge judge(c, c.stops);
  Outcome outcome;
  for (std::size_t k = 0; k < c.stops.size(); ++k)
    outcome.record(c.stops[k], states.data() + k * c.y0.size(), c.y0.size());
  const std::vector<judge::StopError> errors = judge.errors(outcome);
  const auto lost = std::ranges::find_if(
      errors, [&](const judge::StopError& at) { return !(at.error_max <= 1e-3 * judge.scale()); });
  return static_cast<std::size_t>(lost - errors.begin());
}

}  // namespace

std::string limit_of(const Advice& advice, const Case& c) {
  if (advice.run_ns > 0) return "time: nobody has less error within it";
  return winner_of(advice).mode == Mode::fixed ? limit_of_fixed(advice, c)
                                               : limit_of_adaptive(advice, c);
}

std::string growth_of(const Advice& advice, const Case& c) {
  constexpr std::size_t most = 64;
  constexpr double much = 100, part = 0.1;
  if (c.y0.size() > most) return {};
  const Candidate& winner = winner_of(advice);
  Request request = winner.found->request();
  request.stops = c.stops;
  request.over_stops = !advice.on_stops && winner.mode == Mode::adaptive;
  const Outcome own = winner.entrant->solve(request);
  if (own.status != Status::ok) return {};
  State problem(c.stops.size()), run(c.stops.size());
  std::size_t followed = 0;
  try {
    judge::Flow flow(c, c.stops.back(), "dormand_prince853", c.tolerance.with_relative(1e-10));
    const State base = flow.solve(c.t0, c.y0, c.stops);
    followed = stops_followed(c, base);
    for (const State& start : changed_starts(c)) {
      take_growth(c, start, base, flow.solve(c.t0, start, c.stops), problem);
      const measure::Recording changed(c, c.t0, start);
      const Entrant* const entrant = changed.solver(winner.entrant->info.id());
      const Outcome outcome = entrant ? entrant->solve(request) : refused("");
      if (outcome.status != Status::ok) return {};
      take_growth(c, start, own.states, outcome.states, run);
    }
  } catch (const std::runtime_error&) {
    return {};  // the flow itself can't be followed
  }
  // Beyond the stop at which the flow is lost it tells of growth alone.
  const std::size_t at = std::min(followed, c.stops.size() - 1);
  if (!(problem[at] >= much)) return {};
  const std::string grows =
      fmt::format("a change of the start by a millionth is {:.2g} times as large at t = {:g}",
                  problem[at], c.stops[at]);
  if (run[at] >= part * problem[at])
    return grows + ", in this run, too: an error of the initial state counts as much";
  return grows +
         fmt::format(
             " and {:.2g} times in this run, whose steps damp what grows: the setting holds "
             "for this start alone",
             run[at]);
}

}  // namespace odeum::advise
