// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/settings.hpp"

#include <algorithm>
#include <cmath>

namespace odeum::study {
namespace {

bool is_small(const Case& c) { return c.y0.size() <= dense_dimension_limit; }

// Where orders are measured, on the smooth cases and the cloths, the case sets the budget. Many
// solvers cannot solve the hard ones at all: with this budget a full study spends five minutes on
// them.
bool shows_orders(const Case& c) { return c.nature.smooth || c.settings.orders_in_full; }
constexpr std::uint64_t hard_budget = 30'000, quick_hard_budget = 10'000;
// A small problem's extra runs together: half a second at a microsecond for each evaluation.
constexpr std::uint64_t cheap_evaluations = 500'000;

std::uint64_t share_of(const Case& c, std::uint64_t steps) {
  const double share = (convergence_stops(c).back() - c.t0) / (c.stops.back() - c.t0);
  return nearest_multiple(share * static_cast<double>(steps), 1);
}
std::uint64_t multiple_of(const Case& c) { return share_of(c, c.settings.steps_multiple); }

// Step counts from coarse to fine. A factor of two between steps suits low orders; a high order
// reaches rounding within a few halvings, so that its steps are closer together and start coarser.
std::vector<std::uint64_t> step_counts(const Case& c, double order, bool quick) {
  const double p = std::isnan(order) ? 2 : order;
  const double ratio = p <= 2 ? 2 : p <= 4 ? std::sqrt(2.0) : std::cbrt(2.0);
  const int count = p <= 2 ? 11 : p <= 4 ? 16 : p < 8 ? 20 : 23;
  const double start = static_cast<double>(share_of(c, c.settings.coarsest_steps)) / (p <= 4  ? 1
                                                                                      : p < 8 ? 2
                                                                                              : 4);
  const bool every_other = quick && p > 2;
  std::vector<std::uint64_t> ladder =
      step_ladder(start, every_other ? ratio * ratio : ratio, every_other ? (count + 1) / 2 : count,
                  multiple_of(c));
  while (ladder.size() > 8 && ladder.back() > share_of(c, c.settings.finest_steps))
    ladder.pop_back();
  // Low orders settle late.
  const std::size_t most = !quick ? ladder.size() : p <= 1 ? 9 : p <= 4 ? 8 : 6;
  if (ladder.size() > most) ladder.resize(most);
  return ladder;
}

}  // namespace

std::vector<double> convergence_stops(const Case& c) {
  if (c.settings.orders_to_first_stop) return {c.stops.front()};
  return c.stops;
}

std::vector<Request> convergence_settings(const Pair& pair, bool quick) {
  std::vector<Request> requests;
  Request request;
  request.mode = pair.mode;
  request.stops = convergence_stops(*pair.c);
  request.budget.evaluations = pair.c->settings.evaluation_budget;
  const bool many = !is_small(*pair.c);
  if (!shows_orders(*pair.c))
    request.budget.evaluations =
        std::min(request.budget.evaluations, quick ? quick_hard_budget : hard_budget);
  if (quick) request.budget.evaluations /= many ? 32 : 2;
  // A scene's coarsest steps are those that trial runs need: enough for a ladder from there.
  if (quick && pair.c->measures_particles)
    request.budget.evaluations = std::max(request.budget.evaluations,
                                          64 * share_of(*pair.c, pair.c->settings.coarsest_steps));
  if (pair.mode == Mode::fixed) {
    for (const std::uint64_t steps : step_counts(*pair.c, pair.entrant->info.order, quick)) {
      request.steps = steps;
      requests.push_back(request);
    }
  } else {
    const int finest = quick || many ? 8 : !shows_orders(*pair.c) ? 10 : 12;
    // Orders are measured at fixed steps; a tolerance is met within this, or the order is too low
    // for it.
    if (many && !quick) request.budget.evaluations /= 4;
    requests = tolerance_ladder(request, *pair.c, finest);
  }
  return requests;
}

std::vector<Request> settings_between(const Pair& pair, Request request,
                                      std::vector<std::uint64_t> informative, bool to_rounding) {
  const bool small = is_small(*pair.c), smooth = pair.c->nature.smooth;
  if (small ? !smooth && !to_rounding : !smooth || !to_rounding) return {};
  constexpr std::size_t most_of_long_runs = 5;
  if (!small && informative.size() > most_of_long_runs)
    informative.erase(informative.begin(), informative.end() - most_of_long_runs);
  std::vector<Request> requests;
  const std::uint64_t multiple = multiple_of(*pair.c);
  for (std::size_t i = 0; i + 1 < informative.size(); ++i) {
    const auto coarse = static_cast<double>(informative[i]),
               fine = static_cast<double>(informative[i + 1]);
    request.steps = informative[i];
    for (const double share : {0.25, 0.5, 0.75}) {
      const double wanted = coarse * std::pow(fine / coarse, share);
      const std::uint64_t between = nearest_multiple(wanted, multiple);
      if (between <= request.steps || between >= informative[i + 1]) continue;
      request.steps = between;
      requests.push_back(request);
    }
  }
  return requests;
}

std::vector<Request> settings_beyond(const Pair& pair, Request request,
                                     const std::vector<std::uint64_t>& informative) {
  const bool small = is_small(*pair.c);
  if (informative.empty() || (!small && !pair.c->nature.smooth)) return {};
  // Runs that are cheap go to a sixteenth of the step.
  std::uint64_t& budget = request.budget.evaluations;
  budget = small ? cheap_evaluations : 3 * budget;
  std::vector<Request> requests;
  const std::uint64_t multiple = multiple_of(*pair.c);
  for (int k = 1; k <= (small ? 8 : 4); ++k) {
    request.steps =
        nearest_multiple(static_cast<double>(informative.back()) * std::pow(2, k / 2.0), multiple);
    requests.push_back(request);
  }
  return requests;
}

std::vector<Request> tolerances_between(const Pair& pair, Request request,
                                        const std::vector<double>& solved) {
  std::vector<Request> requests;
  for (std::size_t i = 0; i + 1 < solved.size(); ++i) {
    set_tolerance(request, *pair.c, of_two_digits(std::sqrt(solved[i] * solved[i + 1])));
    requests.push_back(request);
  }
  return requests;
}

std::vector<Request> tolerances_beyond(const Pair& pair, Request request, double finest) {
  if (!is_small(*pair.c)) return {};
  std::vector<Request> requests;
  constexpr double tightest = 1e-13;  // methods in double can hardly ask for less
  request.budget.evaluations = cheap_evaluations;
  for (double tolerance = finest / std::sqrt(10); tolerance > 0.9 * tightest;
       tolerance /= std::sqrt(10)) {
    set_tolerance(request, *pair.c, of_two_digits(tolerance));
    requests.push_back(request);
  }
  return requests;
}

}  // namespace odeum::study
