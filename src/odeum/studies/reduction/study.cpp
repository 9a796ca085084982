// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/reduction/reduction.hpp"

namespace odeum::study {
namespace {

std::string table(const ReductionResult& result) {
  return record::table_of(result.rows, {{"solver", "{library}/{solver}"},
                                        {"lambda", "{lambda:.0e}"},
                                        {"claimed", "{claimed_order:.3g}"},
                                        {"measured", "{measured_order:.3f}"},
                                        {"error", "{error_finest:.1e}"},
                                        {"verdict", "{verdict}: {reason}"}})
      .text();
}

}  // namespace

std::unique_ptr<Study> make_reduction() {
  return make_study<ReductionResult>(
      {.name = "reduction",
       .help = "the order on Prothero and Robinson's problem as it becomes stiff",
       .place = 40,
       .cases_help = "",
       .figures = {{"end", reduction_end},
                   {"fewest_steps", reduction_fewest},
                   {"most_steps", reduction_most}}},
      {.measure = measure_reduction, .table = table});
}

}  // namespace odeum::study
