// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/csv.hpp"
#include "odeum/study/reduction.hpp"

namespace odeum::study {

void write_csv(const std::vector<ReductionRow>& rows, const report::OutputFolder& folder) {
  report::CsvTable table(
      "library,solver,lambda,claimed_order,measured_order,error_finest,order_low,order_high,points,"
      "verdict,reason");
  for (const ReductionRow& row : rows)
    table.add(report::CsvRow()
                  .text(row.library)
                  .text(row.solver)
                  .number(row.lambda)
                  .number(row.claimed_order)
                  .number(row.fit.order)
                  .number(row.error_finest)
                  .number(row.fit.low)
                  .number(row.fit.high)
                  .count(row.fit.points)
                  .text(to_string(row.fit.verdict))
                  .text(row.fit.reason));
  folder.write("order_reduction.csv", table.text());
}

}  // namespace odeum::study
