// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/hard_cases/hard_cases.hpp"

#include <iterator>
#include <set>

namespace odeum::study {
namespace {

/// Globs for all solvers of the peers, one a library, but for one library where it is named.
std::vector<std::string> globs_of_peers(const std::string& but = "") {
  std::set<std::string> libraries;
  for (const Case& c : all_cases())
    for (const Entrant& entrant : c.entrants) libraries.insert(entrant.info.library);
  libraries.erase("odeum");
  libraries.erase(but);
  std::vector<std::string> globs;
  globs.reserve(libraries.size());
  for (const std::string& library : libraries) globs.push_back(library + "/*");
  return globs;
}

void append(DriftResult& all, DriftResult more) {
  std::move(more.rows.begin(), more.rows.end(), std::back_inserter(all.rows));
  std::move(more.horizons.begin(), more.horizons.end(), std::back_inserter(all.horizons));
}

}  // namespace

HardCaseResults measure_hard_cases(unsigned jobs) {
  HardCaseResults all;
  all.measured = true;
  all.reduction = measure_reduction({}, Runner(jobs)).rows;
  all.largest_steps = measure_limits({.cases = {}, .solvers = {"odeum/*"}, .jobs = jobs});
  all.drift = measure_drift({.cases = {}, .solvers = {"odeum/*"}, .jobs = jobs});
  // A list of no solvers would mean all of them.
  const std::vector<std::string> peers = globs_of_peers();
  if (!peers.empty()) {
    const std::vector<std::string> hard(std::begin(limit_cases_of_peers),
                                        std::end(limit_cases_of_peers)),
        kept(std::begin(drift_cases_of_peers), std::end(drift_cases_of_peers));
    for (LargestStep& row : measure_limits({.cases = hard, .solvers = peers, .jobs = jobs}))
      all.largest_steps.push_back(std::move(row));
    append(all.drift, measure_drift({.cases = kept, .solvers = peers, .jobs = jobs}));
  }
  if (const auto rest = globs_of_peers(library_without_horizons); !rest.empty())
    append(all.drift, measure_drift({.cases = {horizon_case}, .solvers = rest, .jobs = jobs}));
  return all;
}

}  // namespace odeum::study
