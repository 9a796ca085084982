// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/checks.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/sweep/runner.hpp"
#include "odeum/truth/computed_truth.hpp"

namespace odeum::sweep {
namespace {

/// `count` members of all, evenly spread.
std::uint64_t spread(const Plan& plan, std::uint64_t k, std::uint64_t count) {
  return count < 2 ? 0 : k * (plan.members.size() - 1) / (count - 1);
}

/// NaN where the run fails or nothing is known at the end.
double error_of(const Plan& plan, std::uint64_t member) {
  try {
    Case c = plan.base->with_values(parameters_of(plan, member));
    const double end = plan.request.stops.back();
    std::vector<double> state(c.y0.size());
    if (!c.truth.at || !c.truth.at(end, state.data())) c.truth = truth::truth_at(c, {end});
    const Entrant* const entrant = c.entrants.find(plan.solver);
    if (!entrant || !entrant->solve) return nan;
    Request request = plan.request;
    request.stops = {end};
    const Outcome outcome = entrant->solve(request);
    return outcome.status == Status::ok
               ? judge::Judge(c, request.stops).errors(outcome).back().error_max
               : nan;
  } catch (const std::exception&) {
    return nan;  // values that make no problem, or a truth that cannot be computed
  }
}

/// From the errors of all members, where they are a quantity.
bool check_all(const Plan& plan, Result& result) {
  const auto& all = plan.quantities;
  const auto at = std::ranges::find_if(
      all, [](const Quantity& quantity) { return quantity.kind == Quantity::Kind::error; });
  if (at == all.end()) return false;
  Checks& checks = result.checks;
  checks = {.all = true, .wanted = result.solved};
  std::vector<double> errors;
  for (std::uint64_t member = 0; member < result.size; ++member) {
    const auto q = static_cast<std::size_t>(at - all.begin());
    const double error = result.results[member * all.size() + q];
    if (std::isnan(error)) continue;
    errors.push_back(error);
    if (!(error <= checks.largest)) checks.largest = error, checks.worst = member;
  }
  checks.made = errors.size();
  checks.median = quantiles(std::move(errors))[2];
  return true;
}

}  // namespace

void check_members(const Plan& plan, Result& result) {
  if (check_all(plan, result)) return;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  Checks& checks = result.checks;
  const std::uint64_t wanted = std::min(plan.checks, plan.members.size());
  checks.wanted = wanted;
  std::vector<double> errors;
  // Those in the middle of the rest first, so that also a few are spread.
  std::uint64_t apart = std::bit_ceil(std::max<std::uint64_t>(wanted, 1));
  std::vector<bool> made(wanted, false);
  for (; apart >= 1; apart /= 2)
    for (std::uint64_t k = 0; k < wanted; k += apart) {
      if (made[k]) continue;
      made[k] = true;
      if (interrupted) throw Interrupted();
      if (std::chrono::duration<double>(Clock::now() - start).count() > plan.check_seconds) break;
      const std::uint64_t member = spread(plan, k, wanted);
      const double error = error_of(plan, member);
      if (std::isnan(error)) continue;
      errors.push_back(error);
      if (!(error <= checks.largest)) checks.largest = error, checks.worst = member;
    }
  checks.made = errors.size();
  checks.median = quantiles(errors)[2];
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
    const Lent runner(runners);
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
