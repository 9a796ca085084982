// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/csv.hpp"
#include "odeum/studies/proof/proof.hpp"

namespace odeum::study {
namespace {

std::string proofs_text(const ProofResult& result) {
  record::CsvTable table(
      "solver,family,claimed_order,claimed_embedded,conditions,conditions_embedded,failing_tree,"
      "code_difference,stability,stability_angle,at_infinity,stability_difference,"
      "stability_points,symplectic_defect,return_defect,energy_periods,energy_first,energy_last,"
      "estimates_well,mutants,caught,equivalent,survived,smallest_caught,needs");
  for (const ProofRow& row : result.rows)
    table.add(record::CsvRow()
                  .text(row.method)
                  .text(row.family)
                  .count(row.order)
                  .count(row.order_embedded)
                  .number(row.conditions < 0 ? ProofRow::nan : row.conditions)
                  .number(row.conditions_embedded < 0 ? ProofRow::nan : row.conditions_embedded)
                  .text(row.failing_tree)
                  .number(row.code_difference)
                  .text(row.has_stability_class ? describe(row.stability) : "")
                  .number(row.has_stability_class ? row.stability.angle : ProofRow::nan)
                  .number(row.has_stability_class ? row.stability.at_infinity : ProofRow::nan)
                  .number(row.stability_difference)
                  .count(row.stability_points)
                  .number(row.symplectic_defect)
                  .number(row.return_defect)
                  .number(row.energy_periods)
                  .number(row.energy_first)
                  .number(row.energy_last)
                  .text(row.estimates.empty()  ? ""
                        : row.estimates_well() ? "yes"
                                               : "no")
                  .count(row.mutants)
                  .count(row.caught)
                  .count(row.equivalent)
                  .count(row.survived())
                  .number(row.smallest_caught)
                  .text(row.needs));
  return table.text();
}

std::string orders_text(const ProofResult& result) {
  record::CsvTable table(
      "solver,ground,claimed_order,measured_order,order_low,order_high,points,verdict,reason,"
      "passes_as_next");
  for (const ProofRow& row : result.rows)
    for (const ProvenOrder& order : row.orders)
      table.add(record::CsvRow()
                    .text(row.method)
                    .text(order.ground)
                    .count(row.order)
                    .number(order.fit.order)
                    .number(order.fit.low)
                    .number(order.fit.high)
                    .count(order.fit.points)
                    .text(to_string(order.fit.verdict))
                    .text(order.fit.reason)
                    .text(order.passes_as_next ? "yes" : "no"));
  return table.text();
}

std::string estimates_text(const ProofResult& result) {
  record::CsvTable table(
      "solver,ground,expected_exponent,measured_exponent,ratio_to_true_error,margin,verdict");
  for (const ProofRow& row : result.rows)
    for (const proof::EstimateQuality& quality : row.estimates)
      table.add(record::CsvRow()
                    .text(row.method)
                    .text(quality.ground)
                    .number(quality.expected_exponent)
                    .number(quality.exponent)
                    .number(quality.ratio)
                    .number(quality.margin)
                    .text(quality.good() ? "good" : "bad"));
  return table.text();
}

std::string mutants_text(const ProofResult& result) {
  record::CsvTable table("solver,kind,change,size,counts,verdict,caught_by,reason");
  for (const proof::Mutant& mutant : result.mutants)
    table.add(record::CsvRow()
                  .text(mutant.method)
                  .text(mutant.kind)
                  .text(mutant.change)
                  .number(mutant.size)
                  .text(counts(mutant) ? "yes" : "no")
                  .text(mutant.caught()     ? "caught"
                        : mutant.survived() ? "survived"
                                            : "equivalent")
                  .text(mutant.caught_by)
                  .text(mutant.equivalent));
  return table.text();
}

}  // namespace

void write_csv(const ProofResult& result, const record::OutputFolder& folder) {
  folder.write("proofs.csv", proofs_text(result));
  folder.write("proof_orders.csv", orders_text(result));
  folder.write("proof_estimates.csv", estimates_text(result));
  folder.write("mutants.csv", mutants_text(result));
}

}  // namespace odeum::study
