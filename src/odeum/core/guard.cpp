// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/guard.hpp"

#include <fmt/format.h>

#include "odeum/core/interrupt.hpp"

namespace odeum {

bool Guard::exhaust(std::string why) {
  tripped_ = true;
  status_ = Status::over_budget;
  detail_ = std::move(why);
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

bool Guard::latch(double t, const double* values, std::size_t n, std::size_t first) {
  tripped_ = true;
  status_ = Status::non_finite;
  for (std::size_t i = 0; i < n; ++i) {
    if (std::isfinite(values[i])) continue;
    detail_ = fmt::format("right-hand side component {} is {} at t = {}", first + i, values[i], t);
    break;
  }
  return false;
}

void Guard::conclude(const Request& request, Outcome& outcome) const {
  outcome.counters.rhs_evaluations = rhs_evaluations_;
  outcome.counters.jacobian_evaluations = jacobian_evaluations_;
  outcome.counters.work = spent();
  if (tripped_) {
    outcome.status = status_;
    outcome.detail = detail_;
    return;
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
