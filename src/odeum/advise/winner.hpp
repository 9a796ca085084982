// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "odeum/advise/race.hpp"

namespace odeum::advise {

/// The first in an order whose command, which has no stop but the end and other steps, makes a run
/// as good as what was timed; else the first whose command has the error, else the first of all.
/// Those before it are dropped, and leave `advice.timed`. `repeat(k)` makes the command's run of
/// candidate k.
void choose_winner(Advice& advice, const std::vector<std::size_t>& order,
                   const std::function<Trial(std::size_t)>& repeat);

}  // namespace odeum::advise
