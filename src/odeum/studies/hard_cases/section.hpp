// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "odeum/report/page_sections.hpp"

/// The parts of the section on hard cases. Each is empty where its study has no rows.
namespace odeum::report {

std::string reduction_part(const PageContext& page);
std::string largest_steps_part(const PageContext& page);
std::string drift_part(const PageContext& page);
std::string oscillator_part(const PageContext& page);
std::string horizons_part(const PageContext& page);

/// Rows by case and solver ("library/method"), in their order. Points into `rows`.
template <class Row>
using RowsByPair = std::map<std::pair<std::string, std::string>, std::vector<const Row*>>;
template <class Row>
RowsByPair<Row> by_pair(const std::vector<Row>& rows) {
  RowsByPair<Row> sorted;
  for (const Row& row : rows) sorted[{row.case_id, row.library + "/" + row.solver}].push_back(&row);
  return sorted;
}

/// Rows of one case or of none, by SolverInfo::id(); those that `kept(row)` is false of are left
/// out.
template <class Row, class Kept>
std::map<std::string, std::vector<const Row*>> by_solver(const std::vector<Row>& rows,
                                                         Kept&& kept) {
  std::map<std::string, std::vector<const Row*>> sorted;
  for (const Row& row : rows)
    if (kept(row)) sorted[row.library + "/" + row.solver].push_back(&row);
  return sorted;
}

/// A table of one row a solver, in a <details> a library, Odeum's open. `cells` gives what follows
/// the solver's name; nothing leaves the solver out. `head` holds the cells after "solver".
std::string solver_tables(const PageContext& page, const std::string& style,
                          const std::string& head,
                          const std::function<std::string(const SolverInfo&)>& cells);

/// Whether one solver keeps the symplectic form: by its family, or by the proofs of this run.
bool is_symplectic(const ReportData& data, const SolverInfo& solver);

/// By what power of time an error grows: the slope between its largest in the last tenth of the
/// times and in the tenth before. 0 where all is rounding, NaN with too few rows.
double growth_power(const std::vector<const study::DriftRow*>& series);

/// One quantity over time, of every solver as a line, both logarithmic; empty without a row.
std::string drift_diagram(const PageContext& page, const std::string& case_id,
                          const std::string& quantity);

}  // namespace odeum::report
