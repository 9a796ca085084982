// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/rows.hpp"
#include "odeum/studies/hard_cases/hard_cases.hpp"

namespace odeum::study {

void write_csv(const DriftResult& result, const record::OutputFolder& folder) {
  record::write_rows(result.rows, folder);
  record::write_rows(result.horizons, folder);
}

void write_csv(const std::vector<LargestStep>& rows, const record::OutputFolder& folder) {
  record::write_rows(rows, folder);
}

void write_csv(const HardCaseResults& result, const record::OutputFolder& folder) {
  write_csv(result.drift, folder);
  write_csv(result.largest_steps, folder);
  record::write_rows(result.reduction, folder);
}

HardCaseResults read_hard_cases(const std::filesystem::path& folder) {
  HardCaseResults all;
  all.drift.rows = record::read_rows<DriftRow>(folder, all.problem);
  all.drift.horizons = record::read_rows<HorizonRow>(folder, all.problem);
  all.largest_steps = record::read_rows<LargestStep>(folder, all.problem);
  all.reduction = record::read_rows<ReductionRow>(folder, all.problem);
  return all;
}

}  // namespace odeum::study
