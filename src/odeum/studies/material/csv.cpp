// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/rows.hpp"
#include "odeum/studies/material/rows.hpp"

namespace odeum::study {

void write_csv(const MaterialResult& result, const record::OutputFolder& folder) {
  using record::write_rows;
  record::write_rows(result.material, folder);
  record::write_rows(result.errors, folder);
  record::write_rows(result.long_run, folder);
  // A run of chosen solvers times no engine, and leaves what an earlier run timed.
  if (!result.cost.empty()) record::write_rows(result.cost, folder);
  if (!result.implicit_wins.empty()) record::write_rows(result.implicit_wins, folder);
}

MaterialResult read_material_csv(const std::filesystem::path& folder) {
  using record::read_rows;
  MaterialResult result;
  result.material = record::read_rows<MaterialRow>(folder, result.problem);
  result.errors = record::read_rows<ErrorPartsRow>(folder, result.problem);
  result.long_run = record::read_rows<LongRunRow>(folder, result.problem);
  result.cost = record::read_rows<ClothCostRow>(folder, result.problem);
  result.implicit_wins = record::read_rows<ImplicitWinsRow>(folder, result.problem);
  return result;
}

}  // namespace odeum::study
