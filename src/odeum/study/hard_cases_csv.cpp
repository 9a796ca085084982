// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/csv_rows.hpp"
#include "odeum/study/hard_cases.hpp"

namespace odeum::study {

void write_csv(const DriftResult& result, const report::OutputFolder& folder) {
  report::write_rows(result.rows, folder);
  report::write_rows(result.horizons, folder);
}

void write_csv(const std::vector<LargestStep>& rows, const report::OutputFolder& folder) {
  report::write_rows(rows, folder);
}

void write_csv(const std::vector<ReductionRow>& rows, const report::OutputFolder& folder) {
  report::write_rows(rows, folder);
}

void write_csv(const HardCaseResults& result, const report::OutputFolder& folder) {
  write_csv(result.drift, folder);
  write_csv(result.largest_steps, folder);
  write_csv(result.reduction, folder);
}

HardCaseResults read_hard_cases(const std::filesystem::path& folder) {
  HardCaseResults all;
  all.drift.rows = report::read_rows<DriftRow>(folder, all.problem);
  all.drift.horizons = report::read_rows<HorizonRow>(folder, all.problem);
  all.largest_steps = report::read_rows<LargestStep>(folder, all.problem);
  all.reduction = report::read_rows<ReductionRow>(folder, all.problem);
  return all;
}

}  // namespace odeum::study
