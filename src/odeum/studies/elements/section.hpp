// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/record/table.hpp"
#include "odeum/report/page.hpp"
#include "odeum/studies/elements/rows.hpp"

namespace odeum::study {

struct ElementsTable {
  std::string title;
  record::Table table;
};
/// Orders, solvers, stopping and times, for the terminal and for the page.
std::vector<ElementsTable> elements_tables(const ElementsResult& result);

void add_elements_section(report::Page& page, const ElementsResult& result,
                          const report::Origin& origin);

}  // namespace odeum::study
