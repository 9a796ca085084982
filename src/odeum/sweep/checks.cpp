// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/runner.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

#include "odeum/core/clocks.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/truth/computed_truth.hpp"

namespace odeum::sweep {
namespace {

/// NaN where the run fails or nothing is known at the end.
double error_of(const Plan& plan, std::uint64_t member) {
  try {
    Case c = plan.base->with_values(parameters_of(plan, member), {});
    const double end = plan.request.stops.back();
    truth::know_truth(c, {end});
    Request request = plan.request;
    request.stops = {end};
    const Outcome outcome = fitting(c.entrants, plan.solver).solve(request);
    return outcome.status == Status::ok ? judge::error_at(c, end, outcome.states.data()) : nan;
  } catch (const std::exception&) {
    return nan;  // values that make no problem, a solver that does not fit, or no truth
  }
}

}  // namespace

void check_members(const Plan& plan, Result& result) {
  const auto start = std::chrono::steady_clock::now();
  Checks& checks = result.checks;
  std::vector<double> errors;
  const auto note = [&](std::uint64_t member, double error) {
    if (std::isnan(error)) return;
    errors.push_back(error);
    if (!(error <= checks.largest)) checks.largest = error, checks.worst = member;
  };
  const std::size_t quantities = plan.quantities.size();
  const auto q = static_cast<std::size_t>(
      std::ranges::find(plan.quantities, Quantity::Kind::error, &Quantity::kind) -
      plan.quantities.begin());
  if (q < quantities) {
    checks = {.all = true, .wanted = result.solved};
    for (std::uint64_t member = 0; member < result.size; ++member)
      note(member, result.results[member * quantities + q]);
  } else {
    checks.wanted = std::min(plan.checks, plan.members.size());
    // The order takes the middle of the rest first, so that also a few are spread.
    std::vector<bool> made(checks.wanted, false);
    for (auto apart = std::bit_ceil(std::max<std::uint64_t>(checks.wanted, 1)); apart >= 1;
         apart /= 2)
      for (std::uint64_t k = 0; k < checks.wanted; k += apart) {
        if (made[k]) continue;
        made[k] = true;
        if (interrupted) throw Interrupted();
        if (seconds_since(start) > plan.check_seconds) break;
        const std::uint64_t member = spread(plan, k, checks.wanted);
        note(member, error_of(plan, member));
      }
  }
  checks.made = errors.size();
  checks.median = quantiles(std::move(errors))[2];
}

void add_over_time(const Plan& plan, Result& result) {
  constexpr std::uint64_t most = 500;
  const std::uint64_t count = std::min(plan.members.size(), most);
  const std::vector<std::string> names = component_names(*plan.base);
  const std::vector<double>& stops = plan.over_time.stops;
  const std::size_t n = names.size();
  Runners runners(plan);
  std::vector<std::vector<double>> states(count);
  parallel_for(count, plan.jobs, [&](std::size_t k) {
    const std::shared_ptr<Runner> runner = runners.lend();
    Outcome outcome = runner->run(parameters_of(plan, spread(plan, k, count)), plan.over_time);
    if (outcome.status != Status::ok) return;
    states[k] = runner->y0();
    states[k].insert(states[k].end(), outcome.states.begin(), outcome.states.end());
  });
  std::erase_if(states, [](const auto& each) { return each.empty(); });
  result.over_time_members = states.size();
  result.over_time.columns = {"time", "component", "least", "low", "median", "high", "greatest"};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t at = 0; at <= stops.size(); ++at) {
      std::vector<double> values;
      for (const auto& each : states) values.push_back(each[at * n + i]);
      const Quantiles q = quantiles(std::move(values));
      result.over_time.rows.push_back(
          {at == 0 ? plan.base->t0 : stops[at - 1], names[i], q[0], q[1], q[2], q[3], q[4]});
    }
}

}  // namespace odeum::sweep
