// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/studies/drift/drift.hpp"
#include "odeum/studies/limits/limits.hpp"
#include "odeum/studies/reduction/reduction.hpp"

namespace odeum::study {

/// What the studies of long runs and of stiffness say together, as a report shows it.
struct HardCaseResults {
  DriftResult drift;
  std::vector<LargestStep> largest_steps;
  std::vector<ReductionRow> reduction;
  std::string problem;    ///< why results of an earlier run could not be used; sentences
  bool measured = false;  ///< by this run, and not only read back
  bool empty() const {
    return drift.rows.empty() && drift.horizons.empty() && largest_steps.empty() &&
           reduction.empty();
  }
};

/// The cases on which peers are run too, see the studies' own report_runs.
inline constexpr const char* drift_cases_of_peers[] = {"kepler_e06", "osc_undamped"};
inline constexpr const char* limit_cases_of_peers[] = {"prothero_robinson_1e3_smooth", "vdp_mu1000",
                                                       "stiff_chain2_k1e4"};
inline constexpr const char* horizon_case = "lorenz_kehlet_logg";
inline constexpr const char* library_without_horizons = "arkode";

}  // namespace odeum::study
