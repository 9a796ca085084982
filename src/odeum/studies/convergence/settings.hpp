// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "odeum/studies/runner.hpp"

namespace odeum::study {

/// Where a study of convergence measures errors: at a case's stops, or at the
/// first of them alone where the case says so.
std::vector<double> convergence_stops(const Case& c);

/// The settings at which a study of convergence runs a pair, from coarse to fine: numbers of steps,
/// or tolerances from 1e-3 on.
std::vector<Request> convergence_settings(const Pair& pair, bool quick);

/// Extra settings where an order is open: between the numbers of steps in `informative`, from
/// coarse to fine (`to_rounding`: errors reach it), or beyond the last of them. For large problems
/// only where they are smooth. All else as in `request`, one of the pair's settings.
std::vector<Request> settings_between(const Pair& pair, Request request,
                                      std::vector<std::uint64_t> informative, bool to_rounding);
std::vector<Request> settings_beyond(const Pair& pair, Request request,
                                     const std::vector<std::uint64_t>& informative);

/// Runs to tolerances halfway between those in `solved`, from loose to tight, and beyond the last
/// of them, for small problems alone. All else is as in `request`.
std::vector<Request> tolerances_between(const Pair& pair, Request request,
                                        const std::vector<double>& solved);
std::vector<Request> tolerances_beyond(const Pair& pair, Request request, double finest);

}  // namespace odeum::study
