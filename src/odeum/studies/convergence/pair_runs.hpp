// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::study {

/// Why nothing can be measured; empty: it can.
const std::string& reason_against(const Pair& pair);
ConvergenceResult not_measured(const Pair& pair, const std::string& reason);

/// Runs of one pair from coarse to fine, and the measured order. `gain`: the case's amplification
/// of perturbations, see judge/rounding.hpp.
ConvergenceResult converge_pair(const Pair& pair, double gain, bool quick);

}  // namespace odeum::study
