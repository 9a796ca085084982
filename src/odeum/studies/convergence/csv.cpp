// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/csv.hpp"
#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::study {

void write_csv(const ConvergenceResult& result, const record::OutputFolder& folder) {
  record::CsvTable convergence(
      "case,library,solver,status,detail,step,steps,error_max,error_rms,energy_error,rhs_"
      "evaluations,"
      "jacobian_evaluations,mode,tolerance,rejected_steps");
  for (const ConvergenceRow& row : result.rows)
    convergence.add(record::CsvRow()
                        .text(row.case_id)
                        .text(row.library)
                        .text(row.solver)
                        .text(row.status)
                        .text(row.detail)
                        .number(row.step)
                        .count(row.steps)
                        .number(row.error_max)
                        .number(row.error_rms)
                        .number(row.energy_error)
                        .count(row.counters.rhs_evaluations)
                        .count(row.counters.jacobian_evaluations)
                        .text(to_string(row.mode))
                        .number(row.tolerance)
                        .count(row.counters.rejected_steps));
  folder.write("convergence.csv", convergence.text());

  record::CsvTable times(
      "case,library,solver,mode,step,time,error_max,error_rms,energy,energy_error");
  for (const TimeRow& row : result.times)
    times.add(record::CsvRow()
                  .text(row.case_id)
                  .text(row.library)
                  .text(row.solver)
                  .text(to_string(row.mode))
                  .number(row.step)
                  .number(row.time)
                  .number(row.error_max)
                  .number(row.error_rms)
                  .number(row.energy)
                  .number(row.energy_error));
  folder.write("convergence_times.csv", times.text());

  record::CsvTable orders(
      "case,library,solver,claimed_order,measured_order,order_low,order_high,points,step_coarsest,"
      "step_finest,floor,verdict,reason,mode");
  for (const OrderRow& row : result.orders)
    orders.add(record::CsvRow()
                   .text(row.case_id)
                   .text(row.library)
                   .text(row.solver)
                   .number(row.claimed_order)
                   .number(row.fit.order)
                   .number(row.fit.low)
                   .number(row.fit.high)
                   .count(row.fit.points)
                   .number(row.fit.step_coarsest)
                   .number(row.fit.step_finest)
                   .number(row.fit.floor)
                   .text(to_string(row.fit.verdict))
                   .text(row.fit.reason)
                   .text(to_string(row.mode)));
  folder.write("orders.csv", orders.text());
}

}  // namespace odeum::study
