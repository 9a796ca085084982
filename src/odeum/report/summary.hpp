// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

#include "odeum/record/output_folder.hpp"
#include "odeum/report/report_data.hpp"

namespace odeum::report {

/// A verdict as the page shows it; its CSS class and name are its to_string.
struct VerdictStyle {
  judge::Verdict verdict;
  const char* glyph;    ///< tells verdicts apart without colour
  const char* meaning;  ///< in a clause
};

/// Every verdict, the best first.
inline constexpr std::array<VerdictStyle, 7> verdict_styles{{
    {judge::Verdict::confirmed, "✓", "the claimed order lies within the tolerance of the slope"},
    {judge::Verdict::higher, "▲", "errors fall faster than claimed"},
    {judge::Verdict::lower, "▼", "errors fall more slowly than claimed"},
    {judge::Verdict::floors, "⊥", "errors stop falling at a level that is printed"},
    {judge::Verdict::undetermined, "?", "too few points, or no settled slope"},
    {judge::Verdict::failed, "✗", "no run gave a result"},
    {judge::Verdict::not_applicable, "·", "the solver does not fit the case, or there is no claim"},
}};

inline const VerdictStyle& style_of(judge::Verdict verdict) {
  return verdict_styles[static_cast<std::size_t>(verdict)];
}

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
