// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/csv.hpp"
#include "odeum/study/drift.hpp"

namespace odeum::study {

void write_csv(const DriftResult& result, const report::OutputFolder& folder) {
  report::CsvTable drift(
      "case,library,solver,status,step,time,invariant,relative_error,value,detail");
  for (const DriftRow& row : result.rows)
    drift.add(report::CsvRow()
                  .text(row.case_id)
                  .text(row.library)
                  .text(row.solver)
                  .text(row.status)
                  .number(row.step)
                  .number(row.time)
                  .text(row.invariant)
                  .number(row.relative_error)
                  .number(row.value)
                  .text(row.detail));
  folder.write("drift.csv", drift.text());

  report::CsvTable horizons("case,library,solver,status,detail,mode,setting,horizon");
  for (const HorizonRow& row : result.horizons)
    horizons.add(report::CsvRow()
                     .text(row.case_id)
                     .text(row.library)
                     .text(row.solver)
                     .text(row.status)
                     .text(row.detail)
                     .text(to_string(row.mode))
                     .number(row.setting)
                     .number(row.horizon));
  folder.write("horizons.csv", horizons.text());
}

}  // namespace odeum::study
