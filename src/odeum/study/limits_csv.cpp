// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/csv.hpp"
#include "odeum/study/limits.hpp"

namespace odeum::study {

void write_csv(const std::vector<LargestStep>& rows, const report::OutputFolder& folder) {
  report::CsvTable table(
      "case,library,solver,status,detail,largest_stable_step,predicted_step,eigenvalue_re,"
      "eigenvalue_im,window");
  for (const LargestStep& row : rows)
    table.add(report::CsvRow()
                  .text(row.case_id)
                  .text(row.library)
                  .text(row.solver)
                  .text(row.status)
                  .text(row.detail)
                  .number(row.largest_stable_step)
                  .number(row.predicted_step)
                  .number(row.eigenvalue.real())
                  .number(row.eigenvalue.imag())
                  .number(row.window));
  folder.write("largest_steps.csv", table.text());
}

}  // namespace odeum::study
