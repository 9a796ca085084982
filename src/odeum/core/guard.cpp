// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/guard.hpp"

#include <fmt/format.h>

#include "odeum/core/interrupt.hpp"

namespace odeum {

bool Guard::exhaust(std::string why) {
  exhausted_ = std::move(why);
  return false;
}

bool Guard::may_go_on() {
  if (interrupted) return exhaust("interrupted");
  if (spent() >= budget_.evaluations)
    return exhaust(fmt::format("more than {} evaluations of the right-hand side{}",
                               budget_.evaluations,
                               products_ ? " and products of its derivative" : ""));
  if (seconds() > budget_.seconds) return exhaust(fmt::format("more than {} s", budget_.seconds));
  return true;
}

void Guard::describe(double t, const double* values, std::size_t n, std::size_t first) {
  for (std::size_t i = 0; i < n; ++i) {
    if (std::isfinite(values[i])) continue;
    first_non_finite_ =
        fmt::format("right-hand side component {} is {} at t = {}", first + i, values[i], t);
    return;
  }
}

void Guard::conclude(const Request& request, Outcome& outcome) const {
  outcome.counters.rhs_evaluations = rhs_evaluations_;
  outcome.counters.jacobian_evaluations = jacobian_evaluations_;
  outcome.counters.products = products_;
  outcome.counters.work = spent();
  judge(request, outcome);
  if (outcome.status != Status::ok && !first_non_finite_.empty())
    outcome.detail += "; first non-finite value: " + first_non_finite_;
}

void Guard::judge(const Request& request, Outcome& outcome) const {
  if (tripped()) {
    outcome.status = Status::over_budget;
    outcome.detail = exhausted_;
  }
  if (outcome.status != Status::ok) return;
  for (std::size_t i = 0; i < outcome.states.size(); ++i) {
    if (std::isfinite(outcome.states[i])) continue;
    outcome.status = Status::non_finite;
    outcome.detail = fmt::format("success was reported, but component {} of the state is {}",
                                 i % dimension_, outcome.states[i]);
    return;
  }
  if (outcome.states.size() != request.stops.size() * dimension_ ||
      outcome.t != request.stops.back()) {
    outcome.status = Status::refused;
    outcome.detail = fmt::format("success was reported at t = {}, short of the end t = {}",
                                 outcome.t, request.stops.back());
  }
}

}  // namespace odeum
