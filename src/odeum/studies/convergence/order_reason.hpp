// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/foreseen.hpp"

namespace odeum::study {

/// The order that a pair is held to: at fixed steps on a linear problem with constant coefficients
/// that of the stability function. NaN where none is claimed: it varies during a run, or is above
/// what any method has on the case.
double claimed_order(const Pair& pair);

/// Adds to a verdict what its fit cannot know: how the runs failed, what it costs to go on where
/// the budget ended them, and that a linearly implicit method had to difference its Jacobian.
/// `rows`: all runs of the pair, `foreseen`: by those solved, both from coarse to fine.
void explain(const Pair& pair, const std::vector<const ConvergenceRow*>& rows,
             const Foreseen& foreseen, judge::OrderFit& fit);

/// Why a pair has no order, in words, and what would give it one.
struct OrderClass {
  judge::NoOrder why;
  std::string_view name, settles;
};

/// The classes of the verdicts `failed`, `undetermined` and `over_budget`.
std::span<const OrderClass> order_classes();

}  // namespace odeum::study
