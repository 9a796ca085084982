// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/settings.hpp"

#include <algorithm>
#include <cmath>

namespace odeum::study {
namespace {

// Where orders are measured, on the smooth cases and the cloths, the case sets the budget. Many
// solvers cannot solve the hard ones at all: with this budget a full study spends five minutes on
// them.
bool shows_orders(const Case& c) { return c.has_tag("smooth") || c.has_tag("cloth"); }
constexpr std::uint64_t hard_budget = 30'000, quick_hard_budget = 10'000;

// Step counts from coarse to fine. A factor of two between steps suits low orders; a high order
// reaches rounding within a few halvings, so that its steps are closer together and start coarser.
std::vector<std::uint64_t> step_ladder(const Case& c, double order, bool quick) {
  const double p = std::isnan(order) ? 2 : order;
  const double ratio = p <= 2 ? 2 : p <= 4 ? std::sqrt(2.0) : std::cbrt(2.0);
  const int count = p <= 2 ? 11 : p <= 4 ? 16 : p < 8 ? 20 : 23;
  const double start = static_cast<double>(c.settings.coarsest_steps) / (p <= 4  ? 1
                                                                         : p < 8 ? 2
                                                                                 : 4);
  std::vector<std::uint64_t> ladder;
  for (int k = 0; k < count; ++k) {
    const double wanted = start * std::pow(ratio, k);
    if (quick && p > 2 && k % 2 == 1) continue;
    const auto units = std::llround(wanted / static_cast<double>(c.settings.steps_multiple));
    const std::uint64_t steps =
        static_cast<std::uint64_t>(std::max(units, 1LL)) * c.settings.steps_multiple;
    if (steps > c.settings.finest_steps && ladder.size() >= 8) break;
    if (ladder.empty() || steps > ladder.back()) ladder.push_back(steps);
  }
  if (quick && ladder.size() > 6) ladder.resize(6);
  return ladder;
}

}  // namespace

std::vector<Request> convergence_settings(const Pair& pair, bool quick) {
  std::vector<Request> requests;
  Request request;
  request.mode = pair.mode;
  request.stops = pair.c->stops;
  request.budget.evaluations = pair.c->settings.evaluation_budget;
  const bool many = pair.c->y0.size() > dense_dimension_limit;
  if (!shows_orders(*pair.c))
    request.budget.evaluations =
        std::min(request.budget.evaluations, quick ? quick_hard_budget : hard_budget);
  if (quick) request.budget.evaluations /= many ? 32 : 8;
  if (pair.mode == Mode::fixed) {
    for (const std::uint64_t steps : step_ladder(*pair.c, pair.entrant->info.order, quick)) {
      request.steps = steps;
      requests.push_back(request);
    }
  } else {
    const int finest = quick || many ? 8 : !shows_orders(*pair.c) ? 10 : 12;
    // Orders are measured at fixed steps; a tolerance is met within this, or the order is too low
    // for it.
    if (many && !quick) request.budget.evaluations /= 4;
    for (int exponent = 3; exponent <= finest; ++exponent) {
      set_tolerance(request, *pair.c, std::pow(10.0, -exponent));
      requests.push_back(request);
    }
  }
  return requests;
}

namespace {

// Three numbers of steps between each neighbouring two.
std::vector<Request> settings_between(const Case& c, Request request,
                                      const std::vector<std::uint64_t>& steps) {
  std::vector<Request> requests;
  const auto multiple = static_cast<double>(c.settings.steps_multiple);
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) {
    const auto coarse = static_cast<double>(steps[i]), fine = static_cast<double>(steps[i + 1]);
    request.steps = steps[i];
    for (const double share : {0.25, 0.5, 0.75}) {
      const double wanted = coarse * std::pow(fine / coarse, share);
      const auto between =
          c.settings.steps_multiple * static_cast<std::uint64_t>(std::llround(wanted / multiple));
      if (between <= request.steps || between >= steps[i + 1]) continue;
      request.steps = between;
      requests.push_back(request);
    }
  }
  return requests;
}

// Finer ones, at a larger budget where that of the case is small.
std::vector<Request> settings_beyond(const Case& c, Request request) {
  std::vector<Request> requests;
  const auto units =
      static_cast<double>(request.steps) / static_cast<double>(c.settings.steps_multiple);
  request.budget.evaluations *= 3;
  for (int k = 1; k <= 4; ++k) {
    request.steps = c.settings.steps_multiple *
                    static_cast<std::uint64_t>(std::llround(units * std::pow(2, k / 2.0)));
    requests.push_back(request);
  }
  return requests;
}

}  // namespace

std::vector<Request> second_look(const Pair& pair, const Request& like,
                                 const std::vector<std::uint64_t>& telling, bool to_rounding) {
  if (pair.mode != Mode::fixed || telling.empty()) return {};
  const bool small = pair.c->y0.size() <= dense_dimension_limit;
  if (!small && !pair.c->has_tag("smooth")) return {};
  if (small && (to_rounding || pair.c->has_tag("smooth")))
    return settings_between(*pair.c, like, telling);
  if (to_rounding)
    return settings_between(
        *pair.c, like,
        {telling.end() - static_cast<std::ptrdiff_t>(std::min<std::size_t>(telling.size(), 5)),
         telling.end()});
  Request finest = like;
  finest.steps = telling.back();
  return settings_beyond(*pair.c, finest);
}

}  // namespace odeum::study
