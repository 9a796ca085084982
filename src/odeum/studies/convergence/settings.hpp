// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "odeum/studies/runner.hpp"

namespace odeum::study {

/// The settings at which a study of convergence runs a pair, from coarse to fine: numbers of steps,
/// or tolerances from 1e-3 on.
std::vector<Request> convergence_settings(const Pair& pair, bool quick);

/// Extra settings where the order is undetermined: between the numbers of steps in `telling`, or
/// beyond them where the runs ended before errors reached rounding (`to_rounding`: they did). For
/// large problems only where they are smooth. All else as in `like`, one of the pair's settings.
std::vector<Request> second_look(const Pair& pair, const Request& like,
                                 const std::vector<std::uint64_t>& telling, bool to_rounding);

}  // namespace odeum::study
