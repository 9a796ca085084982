// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>

#include "odeum/judge/order_fit.hpp"
#include "odeum/studies/runner.hpp"

namespace odeum::study {

/// Measures the order of a pair at fixed steps again where double does not determine it, in
/// extended precision, if pair and case have it; `end_of_double` is the number of steps where
/// errors in double are rounding.
void refit_in_extended_precision(const Pair& pair, std::uint64_t end_of_double,
                                 judge::OrderFit& fit);

}  // namespace odeum::study
