// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>

#include "odeum/judge/order_fit.hpp"
#include "odeum/studies/runner.hpp"

namespace odeum::study {

/// The order of a pair at fixed steps in extended precision, from runs about and beyond
/// `rounding_steps`, the number of steps where errors in double are rounding. None where the case
/// or the solver has nothing in extended precision, or long double is double.
std::optional<judge::OrderFit> extended_order(const Pair& pair, std::uint64_t rounding_steps);

}  // namespace odeum::study
