// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// The smallest number of equal steps that has every stop on a step, up to 1000 unless the stops
/// are equally far apart; 0: there is none.
std::uint64_t steps_multiple(double t0, const std::vector<double>& stops);

/// The most steps of an explicit method that are tried, and those above which implicit ones are.
inline constexpr std::uint64_t most_trial_steps = 40'000, many_trial_steps = 1000;

/// Sets the steps with which studies run a case that has its entrants, by trial runs against its
/// truth, and finds it stiff or, where its right-hand side is, smooth. Without a known truth
/// only the multiple.
void choose_steps(Case& c, bool smooth, bool known, std::uint64_t many = many_trial_steps);

}  // namespace odeum::cases
