// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// Looks into the steps of a right-hand side of which nothing but values is at hand: by samples of
/// it, `spacing` apart, along the step. Where one is not what its neighbours let expect, the step
/// has something inside that its stages may have missed. What is shorter than `spacing` may fall
/// between two samples.
std::unique_ptr<Insight> sampled_insight(const System& system, Real spacing);

}  // namespace odeum::truth
