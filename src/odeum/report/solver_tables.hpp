// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "odeum/report/facts.hpp"
#include "odeum/report/table.hpp"

namespace odeum::report {

/// Rows by a key of theirs (a member, or a function of a row), in their order. Points into `rows`.
template <class Row, class Key>
auto group_by(const std::vector<Row>& rows, Key&& key) {
  std::map<std::decay_t<std::invoke_result_t<Key, const Row&>>, std::vector<const Row*>> groups;
  for (const Row& row : rows) groups[std::invoke(key, row)].push_back(&row);
  return groups;
}

template <class Row>
using RowsBySolver = std::map<std::string, std::vector<const Row*>>;

/// Rows by solver ("library/method"), in their order; those that `kept(row)` is false of are left
/// out. Points into `rows`.
template <class Row, class Kept>
RowsBySolver<Row> by_solver(const std::vector<Row>& rows, Kept&& kept) {
  RowsBySolver<Row> sorted;
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

/// The same of rows by solver: `cells(rows)` follows the name of each solver that has some.
template <class Row, class Cells>
std::string solver_tables(const Facts& facts, const std::string& style,
                          const std::vector<Cell>& head, const RowsBySolver<Row>& rows,
                          Cells&& cells) {
  return solver_tables(facts, style, head, [&](const SolverInfo& solver) {
    const auto found = rows.find(solver.id());
    return found == rows.end() ? std::vector<Cell>() : cells(found->second);
  });
}

/// A cell for each column: `cell_of` the first of the rows with `stands_in(row, column)`, else
/// `missing`. Empty where all would be missing.
template <class Row, class Columns, class StandsIn, class CellOf>
std::vector<Cell> cells_by_column(const std::vector<const Row*>& rows, const Columns& columns,
                                  StandsIn&& stands_in, CellOf&& cell_of,
                                  const Cell& missing = {}) {
  std::vector<Cell> cells;
  bool any = false;
  for (const auto& column : columns) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row* each) { return stands_in(*each, column); });
    cells.push_back(row == rows.end() ? missing : cell_of(**row));
    any |= row != rows.end();
  }
  return any ? cells : std::vector<Cell>();
}

/// A header cell that links to the page of a case, written upwards; `more` follows the name.
Cell case_head(const CaseFacts& c, const std::string& more = {});

}  // namespace odeum::report
