// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <string>
#include <vector>

#include "odeum/report/facts.hpp"
#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::study {

/// How the solvers of one library did. A pair is a solver on a case in a mode.
struct LibrarySummary {
  std::string library;
  std::size_t solvers = 0, pairs = 0;
  std::array<std::size_t, static_cast<std::size_t>(judge::Verdict::not_applicable) + 1>
      verdicts{};  ///< counts by Verdict
};
/// One entry a library, then one for all of them, with the name "all".
std::vector<LibrarySummary> summarise(const report::Facts& facts,
                                      const std::vector<OrderRow>& orders);
/// The same for a terminal.
std::string summary_text(const report::Facts& facts, const std::vector<OrderRow>& orders);

}  // namespace odeum::study
