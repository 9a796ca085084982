// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "odeum/formula/problem.hpp"
#include "odeum/problem/events.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// The events of a text for solvers, which do not need the problem; null where it has none.
std::shared_ptr<const Events> events_of(const formula::Problem& problem);

/// Gives a case the switches and the events of its text; whether there are any. A reset may change
/// what the equations keep, so that a case with events has no invariants, and its right-hand side
/// in extended precision is not its whole.
bool take_changes(const formula::Problem& problem, Case& c);

/// What they are, for people; empty where there are none.
std::string events_in_words(const Events* events);

}  // namespace odeum::cases
