// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/evolution/rows.hpp"

namespace odeum::study {
namespace {

record::Table orders_table(const EvolutionResult& result) {
  return record::table_of(result.orders, {{"problem", "{problem}"},
                                          {"solver", "{solver}"},
                                          {"in", "{direction}"},
                                          {"claimed", "{claimed_order:.0f}"},
                                          {"measured", "{measured_order:.2f}"},
                                          {"verdict", "{verdict}: {reason}"}});
}
record::Table cheapest_table(const EvolutionResult& result) {
  return record::table_of(result.cheapest, {{"problem", "{problem}"},
                                            {"error", "{target:.0e}"},
                                            {"solver", "{solver}"},
                                            {"divisions", "{divisions:d}"},
                                            {"steps", "{steps:d}"},
                                            {"h", "{h:.3g}"},
                                            {"dt", "{dt:.3g}"},
                                            {"reached", "{error:.1e}"},
                                            {"multiplications", "{work:.2g}"},
                                            {"status", "{status}"}});
}
record::Table modes_table(const EvolutionResult& result) {
  return record::table_of(result.modes, {{"problem", "{problem}"},
                                         {"mass", "{mass}"},
                                         {"solver", "{solver}"},
                                         {"of", "{quantity}"},
                                         {"half waves", "{waves:d}"},
                                         {"eigenvalue or frequency x dt", "{step:.3g}"},
                                         {"measured", "{observed:.4g}"},
                                         {"predicted", "{predicted:.4g}"}});
}
record::Table limits_table(const EvolutionResult& result) {
  return record::table_of(result.limits, {{"problem", "{problem}"},
                                          {"mass", "{mass}"},
                                          {"solver", "{solver}"},
                                          {"predicted", "{predicted:.5g}"},
                                          {"measured", "{observed:.5g}"}});
}

std::string table(const EvolutionResult& result) {
  return orders_table(result).text() + "\n" + cheapest_table(result).text() + "\n" +
         modes_table(result).text() + "\n" + limits_table(result).text();
}

}  // namespace

std::unique_ptr<Study> make_evolution() {
  return make_study<EvolutionResult>(
      {.name = "evolution",
       .help = "heat and waves by finite elements: errors of mesh and of steps apart, and "
               "the cheapest pair of both",
       .place = 79,
       .cases_help = "",
       .options = {{.name = "most",
                    .help = "divisions of the finest mesh, of which the largest power of "
                            "two is taken; default: 128",
                    .least = 16,
                    .most = 512,
                    .whole = true}},
       .figures = {{"rough_steps", rough_steps}, {"wave_divisions", wave_divisions}}},
      {.measure = measure_evolution, .table = table});
}

}  // namespace odeum::study
