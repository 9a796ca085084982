// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <utility>

#include "odeum/studies/hard_cases/hard_cases.hpp"

namespace odeum::study {
namespace {

/// A case, or none, and a solver.
using Pair = std::pair<std::string, std::string>;

template <class Row>
Pair pair_of(const Row& row) {
  return {row.case_id, row.library + "/" + row.solver};
}
Pair pair_of(const ReductionRow& row) { return {"", row.library + "/" + row.solver}; }

template <class Row>
void add_others(std::vector<Row>& rows, std::vector<Row> earlier, const std::set<Pair>& known) {
  std::set<Pair> measured;
  for (const Row& row : rows) measured.insert(pair_of(row));
  for (Row& row : earlier)
    if (const Pair pair = pair_of(row); known.contains(pair) && !measured.contains(pair))
      rows.push_back(std::move(row));
}

}  // namespace

void add_earlier(HardCaseResults& result, HardCaseResults earlier, const std::vector<Case>& cases) {
  std::set<Pair> known;
  for (const Case& c : cases)
    for (const Entrant& entrant : c.entrants) {
      known.insert({c.id, entrant.info.id()});
      known.insert({"", entrant.info.id()});
    }
  add_others(result.drift.rows, std::move(earlier.drift.rows), known);
  add_others(result.drift.horizons, std::move(earlier.drift.horizons), known);
  add_others(result.largest_steps, std::move(earlier.largest_steps), known);
  add_others(result.reduction, std::move(earlier.reduction), known);
  result.problem = std::move(earlier.problem);
}

}  // namespace odeum::study
