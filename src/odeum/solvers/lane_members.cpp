// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/lane_members.hpp"

namespace odeum {

FamilyMembers::FamilyMembers(const LaneMembers& members, const Request& request, int order)
    : members_(members),
      request_(request),
      order_(order),
      alone_(members.family.alone, nullptr),
      outcomes_(members.count),
      fails_(members.count) {
  for (Outcome& outcome : outcomes_) outcome.status = Status::refused;
}

double FamilyMembers::first_step(std::size_t) const {
  return initial_step(alone_, members_.family.t0, *members_.family.y0, request_.stops.back(),
                      order_, request_.tolerance);
}

void FamilyMembers::seat(std::size_t member, std::size_t lane, Problem& problem,
                         State<Problem>& y) {
  fails_[member] = !members_.place(member);
  for (std::size_t k = 0; k < members_.family.constants->size(); ++k)
    problem.constant(k).set(lane, (*members_.family.constants)[k]);
  for (std::size_t n = 0; n < y.size(); ++n) y[n].set(lane, (*members_.family.y0)[n]);
}

void FamilyMembers::leave(std::size_t member, const MemberEnd& end, const State<Problem>& y,
                          std::size_t lane) {
  if (fails_[member] || end.status != Status::ok || end.rhs_evaluations > most_evaluations())
    return;
  Outcome& outcome = outcomes_[member];
  outcome.t = end.t;
  for (const Lanes& each : y) outcome.states.push_back(each[lane]);
  if (!is_finite(outcome.states.data(), y.size())) return;
  outcome.status = Status::ok;
  outcome.counters.steps = end.steps;
  outcome.counters.rejected_steps = end.rejected_steps;
  outcome.counters.rhs_evaluations = end.rhs_evaluations;
}

}  // namespace odeum
