// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "odeum/record/output_folder.hpp"
#include "odeum/report/report_data.hpp"
#include "odeum/report/verdict_style.hpp"

namespace odeum::report {

/// How the solvers of one library did. A pair is a solver on a case in a mode.
struct LibrarySummary {
  std::string library;
  std::size_t solvers = 0, pairs = 0;
  std::array<std::size_t, verdict_styles.size()> verdicts{};  ///< by Verdict
  std::size_t count(judge::Verdict verdict) const {
    return verdicts[static_cast<std::size_t>(verdict)];
  }
};

/// One entry a library, then one for all of them, with the name "all".
std::vector<LibrarySummary> summarise(const ReportData& data);

/// The number of rows of each status, of convergence and of stability limits together.
std::map<std::string, std::size_t> status_counts(const ReportData& data);

/// The table that ends `odeum report`: verdicts by library, and where the report lies.
std::string summary_table(const ReportData& data, const record::OutputFolder& folder);

}  // namespace odeum::report
