// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "odeum/report/facts.hpp"
#include "odeum/report/table.hpp"

namespace odeum::report {

/// Rows by solver ("library/method"), in their order; those that `kept(row)` is false of are left
/// out. Points into `rows`.
template <class Row, class Kept>
std::map<std::string, std::vector<const Row*>> by_solver(const std::vector<Row>& rows,
                                                         Kept&& kept) {
  std::map<std::string, std::vector<const Row*>> sorted;
  for (const Row& row : rows)
    if (kept(row)) sorted[row.library + "/" + row.solver].push_back(&row);
  return sorted;
}

/// Tables of one row a solver, one for each library in a <details>. `head` follows the corner;
/// `cells(solver)` follows the solver's name, and leaves the solver out where it is empty. `open`:
/// Odeum's own is shown at first.
std::string solver_tables(const Facts& facts, const std::string& style,
                          const std::vector<Cell>& head,
                          const std::function<std::vector<Cell>(const SolverInfo&)>& cells,
                          bool open = true);

/// A header cell that links to the page of a case, written upwards; `more` follows the name.
Cell case_head(const CaseFacts& c, const std::string& more = {});

}  // namespace odeum::report
