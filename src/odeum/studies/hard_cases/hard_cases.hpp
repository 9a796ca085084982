// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
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

/// The cases on which peers are run too: of drift an orbit and an oscillator, of the largest step
/// one for each kind of stiffness (a decay, a relaxation, a vibration).
inline constexpr const char* drift_cases_of_peers[] = {"kepler_e06", "osc_undamped"};
inline constexpr const char* limit_cases_of_peers[] = {"prothero_robinson_1e3_smooth", "vdp_mu1000",
                                                       "stiff_chain2_k1e4"};
inline constexpr const char* horizon_case = "lorenz_kehlet_logg";
/// Not run for its horizons: its many tables take as long there as all the rest.
inline constexpr const char* library_without_horizons = "arkode";

/// Runs a selection that takes seconds: own solvers on every case of the three studies, peers on
/// the cases above, all solvers for the reduction of order. Results do not depend on `jobs`. Throws
/// Interrupted.
HardCaseResults measure_hard_cases(unsigned jobs);

/// What earlier runs left in a folder; nothing where nothing is.
HardCaseResults read_hard_cases(const std::filesystem::path& folder);

/// Adds the pairs of an earlier run that were not measured now and that `cases` still have.
void add_earlier(HardCaseResults& result, HardCaseResults earlier, const std::vector<Case>& cases);

/// drift.csv, horizons.csv, largest_steps.csv and order_reduction.csv.
void write_csv(const HardCaseResults& result, const record::OutputFolder& folder);

}  // namespace odeum::study
