// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/report/page.hpp"
#include "odeum/studies/material/rows.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// What the page shows of a result.
void add_section(report::Page& page, const MaterialResult& result, const Origin& origin);

/// Its parts, each empty without rows.
std::string response_tables(const std::vector<MaterialRow>& rows);
std::string error_parts_table(const std::vector<ErrorPartsRow>& rows);
std::string long_run_table(const std::vector<LongRunRow>& rows);
std::string cloth_cost_table(const std::vector<ClothCostRow>& rows);
std::string implicit_wins_table(const std::vector<ImplicitWinsRow>& rows);

/// A solver and what its step was given: "bullet/soft_body_links, 4 iterations".
template <class Row>
std::string competitor(const Row& row) {
  std::string text = row.library + "/" + row.solver;
  if (row.sweeps > 0)
    text += ", " + std::to_string(row.sweeps) + (row.sweeps == 1 ? " iteration" : " iterations");
  if (row.newton > 0) text += ", " + std::to_string(row.newton) + " Newton";
  return text;
}

/// The shade of a cell for how far a number is from what it should be: t1 to t3 above, t-1 to t-3
/// below; `size` against three limits.
std::string shade(double signed_size, double slight, double strong, double extreme);

/// "1/60 s" for a step that is a whole part of a second, else "0.0125 s".
std::string show_step(double seconds);

}  // namespace odeum::study
