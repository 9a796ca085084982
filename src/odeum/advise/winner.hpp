// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <vector>

#include "odeum/advise/race.hpp"

namespace odeum::advise {

/// The run of a candidate, by its index, as its command makes it with no stop but the end.
using AsCommand = std::function<Trial(std::size_t)>;

/// Chooses the first candidate of `order` (the best first) whose command keeps what was asked: with
/// no stop but the end, or where the wishes allow it with steps that end on the stops, as it was
/// timed. One that needs no stops is preferred where it takes at most a quarter longer. The winner
/// comes first in `advice.timed`, its `found` is its command's run, and those before it are dropped
/// with their reason. Without one there is a failure.
void choose_winner(Advice& advice, const std::vector<std::size_t>& order,
                   const AsCommand& as_command);

}  // namespace odeum::advise
