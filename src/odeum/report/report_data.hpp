// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"
#include "odeum/report/facts.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/hard_cases/hard_cases.hpp"
#include "odeum/studies/material/rows.hpp"
#include "odeum/studies/precision/precision.hpp"
#include "odeum/studies/proof/proof.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::report {

/// Everything that a report tells. Plain data, so that a test can make one up.
struct ReportData : Facts {
  study::ConvergenceResult convergence;
  study::StabilityResult stability;
  study::ProofResult proofs;
  study::PrecisionResult precision;
  study::HardCaseResults hard_cases;
  std::string precision_problem;       ///< why results of an earlier run could not be used
  study::MaterialResult material;      ///< of this run, or of an earlier one into the same folder
  double precision_seconds_limit = 0;  ///< what one solve might take in this run; 0: none was timed

  bool quick = false;
  std::string command_line;
  double seconds = 0;  ///< how long the studies took
  std::chrono::system_clock::time_point finished = std::chrono::system_clock::now();
};

inline std::vector<std::string> library_names(const ReportData& data) {
  return data.library_names();
}
inline std::string library_version(const ReportData& data, const std::string& library) {
  return data.library_version(library);
}

}  // namespace odeum::report
