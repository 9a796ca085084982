// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/foreseen.hpp"

namespace odeum::study {

/// Where a study of convergence measures errors: at a case's stops. A cloth of stiff or
/// tension-only springs runs to the first of them alone: its order shows at steps of 1e-4 s and
/// less.
std::vector<double> convergence_stops(const Case& c);

/// The settings at which a study of convergence runs a pair, from coarse to fine: numbers of steps,
/// or tolerances from 1e-3 on.
std::vector<Request> convergence_settings(const Pair& pair, bool quick);

/// Extra settings where an order is open: between the numbers of steps in `telling`, from coarse to
/// fine (`to_rounding`: errors reach it), or beyond the last of them. For large problems only where
/// they are smooth. All else as in `request`, one of the pair's settings.
std::vector<Request> settings_between(const Pair& pair, Request request,
                                      std::vector<std::uint64_t> telling, bool to_rounding);
std::vector<Request> settings_beyond(const Pair& pair, Request request,
                                     const std::vector<std::uint64_t>& telling);

/// The order that a pair is held to; NaN where none is claimed: it varies during a run, or is above
/// what any method has on the case.
double claimed_order(const Pair& pair);

/// Adds to a verdict what its fit cannot know: how the runs failed, what it costs to go on where
/// the budget ended them, and that a linearly implicit method had to difference its Jacobian.
/// `rows`: all runs of the pair, `costs`: of those solved, both from coarse to fine.
void explain(const Pair& pair, const std::vector<const ConvergenceRow*>& rows,
             const std::vector<Cost>& costs, judge::OrderFit& fit);

/// The order of a pair at fixed steps in extended precision, from runs about and beyond
/// `rounding_steps`, the number of steps where errors in double are rounding. None where the case
/// or the solver has nothing in extended precision, or long double is double.
std::optional<judge::OrderFit> extended_order(const Pair& pair, std::uint64_t rounding_steps);

/// Why nothing can be measured; empty: it can.
const std::string& reason_against(const Pair& pair);
ConvergenceResult not_measured(const Pair& pair, const std::string& reason);

/// What is measured once for a case.
struct CaseMeasures {
  double gain = 0;                          ///< of rounding, see judge/amplification.hpp
  judge::Amplification amplification = {};  ///< at convergence_stops; for runs to a tolerance alone
};

/// Runs of one pair from coarse to fine, and the measured order.
ConvergenceResult converge_pair(const Pair& pair, const CaseMeasures& measures, bool quick);

}  // namespace odeum::study
