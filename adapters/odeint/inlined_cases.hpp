// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeint/inlined.hpp"
#include "odeum/cases/inlined.hpp"

namespace odeum::cases::inlined {

/// Appends odeint's one-step steppers, and its fastest multistep one, where the case has problem P.
template <Ode P>
void add_odeint(const Case& c, std::vector<Entrant>& all) {
  const Contest<Bare<P>> contest = bare_contest<P>(c);
  if (!contest.problem) return;
  adapters::odeint::Roster<Bare<P>> roster(contest, all);
  adapters::odeint::enroll_one_step(roster);
  adapters::odeint::enroll_extrapolation(roster);
  adapters::odeint::enroll_second_order(roster);
  adapters::odeint::enroll_longest_adams(roster);
}

}  // namespace odeum::cases::inlined
