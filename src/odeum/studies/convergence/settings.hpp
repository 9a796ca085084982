// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "odeum/studies/runner.hpp"

namespace odeum::study {

/// The settings at which a study of convergence runs a pair, from coarse to fine: numbers of steps,
/// or tolerances from 1e-3 on.
std::vector<Request> convergence_settings(const Pair& pair, bool quick);

/// Where to look again at a pair whose order stays open, if orders are seen on its case: between
/// the numbers of steps that were telling, or on a large problem, where a short ladder was
/// affordable, beyond them, and between the last of them where that was `to_rounding`. All else as
/// in `like`, one of its settings.
std::vector<Request> second_look(const Pair& pair, const Request& like,
                                 const std::vector<std::uint64_t>& telling, bool to_rounding);

/// What a solve cost, in the units of a budget.
struct Cost {
  double setting;  ///< number of steps, or 1 / tolerance
  double work;
};

/// At least what the next setting will cost, to go by those that were run before it; 0 where
/// nothing is known.
double foreseen_work(const std::vector<Cost>& coarser, const Request& next);

}  // namespace odeum::study
