// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/csv.hpp"
#include "odeum/studies/precision/precision.hpp"

namespace odeum::study {

void write_csv(const PrecisionResult& result, const record::OutputFolder& folder) {
  record::CsvTable precision(
      "case,library,solver,status,detail,setting_kind,setting,error,wall_ns_min,wall_ns_median,"
      "repetitions,rhs_evaluations,jacobian_evaluations,steps,rejected_steps,right_hand_side,"
      "pareto,drift,processor_share,measured");
  record::CsvTable tolerances("case,library,solver,requested,achieved,achieved_over_requested");
  for (const PrecisionRow& row : result.rows) {
    precision.add(record::CsvRow()
                      .text(row.case_id)
                      .text(row.library)
                      .text(row.solver)
                      .text(row.status)
                      .text(row.detail)
                      .text(row.mode == Mode::adaptive ? "tol" : "step")
                      .number(row.setting)
                      .number(row.error)
                      .number(row.wall_ns_min)
                      .number(row.wall_ns_median)
                      .count(row.repetitions)
                      .count(row.counters.rhs_evaluations)
                      .count(row.counters.jacobian_evaluations)
                      .count(row.counters.steps)
                      .count(row.counters.rejected_steps)
                      .text(row.inlined ? "inlined" : "function pointer")
                      .count(row.pareto)
                      .number(row.drift)
                      .number(row.processor_share)
                      .text(row.measured));
    if (row.mode == Mode::adaptive && row.status == to_string(Status::ok))
      tolerances.add(record::CsvRow()
                         .text(row.case_id)
                         .text(row.library)
                         .text(row.solver)
                         .number(row.setting)
                         .number(row.error)
                         .number(row.error / row.setting));
  }
  folder.write("precision.csv", precision.text());
  folder.write("tolerances.csv", tolerances.text());

  record::CsvTable summary("case,error,own,own_ns,peer,peer_ns,ratio,ratio_low,ratio_high,reason");
  for (const PrecisionSummary& line : result.summary)
    summary.add(record::CsvRow()
                    .text(line.case_id)
                    .number(line.error)
                    .text(line.own)
                    .number(line.own_ns)
                    .text(line.peer)
                    .number(line.peer_ns)
                    .number(line.ratio)
                    .number(line.ratio_low)
                    .number(line.ratio_high)
                    .text(line.reason));
  folder.write("precision_summary.csv", summary.text());
}

}  // namespace odeum::study
