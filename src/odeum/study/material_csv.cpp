// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/csv_rows.hpp"
#include "odeum/study/material_rows.hpp"

namespace odeum::study {

void write_csv(const MaterialResult& result, const report::OutputFolder& folder) {
  using report::write_rows;
  write_rows(result.material, folder);
  write_rows(result.errors, folder);
  write_rows(result.long_run, folder);
  // A run of chosen solvers times no engine, and leaves what an earlier run timed.
  if (!result.cost.empty()) write_rows(result.cost, folder);
  if (!result.implicit_wins.empty()) write_rows(result.implicit_wins, folder);
}

MaterialResult read_material_csv(const std::filesystem::path& folder) {
  using report::read_rows;
  MaterialResult result;
  result.material = read_rows<MaterialRow>(folder, result.problem);
  result.errors = read_rows<ErrorPartsRow>(folder, result.problem);
  result.long_run = read_rows<LongRunRow>(folder, result.problem);
  result.cost = read_rows<ClothCostRow>(folder, result.problem);
  result.implicit_wins = read_rows<ImplicitWinsRow>(folder, result.problem);
  return result;
}

}  // namespace odeum::study
