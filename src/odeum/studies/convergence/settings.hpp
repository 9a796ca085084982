// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "odeum/studies/runner.hpp"

namespace odeum::study {

/// The settings at which a study of convergence runs a pair, from coarse to fine: numbers of steps,
/// or tolerances from 1e-3 on.
std::vector<Request> convergence_settings(const Pair& pair, bool quick);

/// Where to look again at a pair whose order stays open: between the numbers of steps that were
/// telling, or beyond them where the ladder ended before errors came to rounding (`to_rounding`:
/// they did). Large problems are looked at again where they are smooth alone. All else as in
/// `like`, one of the pair's settings.
std::vector<Request> second_look(const Pair& pair, const Request& like,
                                 const std::vector<std::uint64_t>& telling, bool to_rounding);

/// The cost of a solve, in the units of a budget.
struct Cost {
  double setting;  ///< number of steps, or 1 / tolerance
  double work;
};

/// A lower bound of the next setting's cost, extrapolated from the last ones; 0 where unknown.
double foreseen_work(const std::vector<Cost>& coarser, const Request& next);

}  // namespace odeum::study
