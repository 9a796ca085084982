// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "odeum/studies/runner.hpp"

namespace odeum::study {

/// The settings at which a study of convergence runs a pair, from coarse to fine: numbers of steps,
/// or tolerances from 1e-3 on.
std::vector<Request> convergence_settings(const Pair& pair, bool quick);

/// Extra settings where the order is undetermined, if orders are measured on the case: between the
/// numbers of steps in `telling`, or beyond them on a large problem with few affordable settings;
/// between the last of them where `to_rounding`. All else as in `like`, one of its settings.
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
