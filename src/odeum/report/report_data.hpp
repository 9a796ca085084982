// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/hard_cases/hard_cases.hpp"
#include "odeum/studies/material/rows.hpp"
#include "odeum/studies/precision/precision.hpp"
#include "odeum/studies/proof/proof.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::report {

/// What the page says about a case, apart from any result.
struct CaseFacts {
  std::string id, title, equation, source, truth;
  double truth_floor = 0;  ///< absolute error below which the truth says nothing
  double timed_floor = 0;  ///< the same where studies of time measure the error
  double timed_end = 0;    ///< the time t at which these do
  double scale = 1;        ///< size of the initial state; an error of it is one of 100 %
  std::vector<std::string> tags;

  bool has_tag(const std::string& tag) const;
};

/// Everything that a report tells. Plain data, so that a test can make one up.
struct ReportData {
  study::ConvergenceResult convergence;
  study::StabilityResult stability;
  study::ProofResult proofs;
  study::PrecisionResult precision;
  study::HardCaseResults hard_cases;
  std::string precision_problem;       ///< why results of an earlier run could not be used
  study::MaterialResult material;      ///< of this run, or of an earlier one into the same folder
  double precision_seconds_limit = 0;  ///< what one solve might take in this run; 0: none was timed

  std::vector<CaseFacts> cases;
  std::vector<SolverInfo> solvers;  ///< each once, in the order of enrolment
  std::vector<LibraryInfo> libraries;

  bool quick = false;
  std::string command_line;
  double seconds = 0;  ///< how long the studies took
  std::chrono::system_clock::time_point finished = std::chrono::system_clock::now();
};

/// Fills cases, solvers and libraries from the project's own lists.
void describe(ReportData& data, const std::vector<Case>& cases,
              const std::vector<LibraryInfo>& libraries);

/// The names of the libraries whose solvers take part, in the order of the solvers.
std::vector<std::string> library_names(const ReportData& data);

/// The version of the library that solvers named `library/...` come from; empty: not known, or
/// ours.
std::string library_version(const ReportData& data, const std::string& library);

}  // namespace odeum::report
