// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::study {

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
