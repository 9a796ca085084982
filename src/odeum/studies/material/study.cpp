// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/material/material.hpp"

namespace odeum::study {
namespace {

std::string table(const MaterialResult& result) {
  return record::table_of(result.material, {{"scene", "{scene}"},
                                            {"solver", "{library}/{solver}"},
                                            {"step", "{step:.3g}"},
                                            {"sweeps", "{sweeps:d}"},
                                            {"newton", "{newton:d}"},
                                            {"static stiffness", "{static_stiffness_ratio:.3g}"},
                                            {"dynamic stiffness", "{dynamic_stiffness_ratio:.3g}"},
                                            {"damping", "{damping:.3g}"},
                                            {"added", "{added_damping_ratio:.2g}"},
                                            {"status", "{status}: {detail}"}})
             .text() +
         '\n' +
         record::table_of(result.errors, {{"errors in m", "{library}/{solver}"},
                                          {"step", "{step:.3g}"},
                                          {"sweeps", "{sweeps:d}"},
                                          {"newton", "{newton:d}"},
                                          {"total", "{total:.2g}"},
                                          {"iteration", "{iteration:.2g}"},
                                          {"time step", "{time_step:.2g}"},
                                          {"model", "{model:.2g}"},
                                          {"status", "{status}: {detail}"}})
             .text();
}

}  // namespace

// It takes a quarter of a minute: a quick report shows the rows of an earlier one.
std::unique_ptr<Study> make_material() {
  return make_study<MaterialResult>(
      {.name = "material",
       .help = "effective stiffness and damping of engines, cloth errors and costs",
       .place = 70,
       .cases_help = "",
       .figures = {{"stiffness", Specimen().stiffness},
                   {"damping", Specimen().damping},
                   {"mass", Specimen().mass},
                   {"masses", static_cast<double>(hanging_chain().masses)},
                   {"cloth_side", cloth_side},
                   {"timed_side", timed_cloth_side},
                   {"timed_time", timed_cloth_time},
                   {"timed_residual", timed_cloth_residual},
                   {"timed_margin", timed_cloth_margin}}},
      {.measure = measure_material, .table = table});
}

}  // namespace odeum::study
