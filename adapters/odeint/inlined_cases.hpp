// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeint/inlined.hpp"
#include "odeum/cases/inlined_contest.hpp"

namespace odeum::cases::inlined {

/// Appends odeint's one-step steppers, and its fastest multistep one, where the case has problem P.
template <Ode P>
void add_odeint(const Case& c, std::vector<Entrant>& all) {
  const Contest<Bare<P>> contest = bare_contest<P>(c);
  if (!contest.problem) return;
  adapters::odeint::Roster<Bare<P>> roster;
  adapters::odeint::add_one_step(roster);
  adapters::odeint::add_extrapolation(roster);
  adapters::odeint::add_second_order(roster);
  adapters::odeint::add_longest_adams(roster);
  adapters::odeint::enroll(roster, contest, all);
}

}  // namespace odeum::cases::inlined
