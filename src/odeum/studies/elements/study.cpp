// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/elements/rows.hpp"

namespace odeum::study {
namespace {

struct TitledTable {
  std::string title;
  record::Table table;
};

std::vector<TitledTable> tables_of(const ElementsResult& result) {
  return {{"Orders in the mesh size h",
           record::table_of(result.orders, {{"problem", "{problem}"},
                                            {"load", "{rule}"},
                                            {"norm", "{norm}"},
                                            {"claimed", "{claimed_order:.2f}"},
                                            {"measured", "{measured_order:.2f}"},
                                            {"finest error", "{error_finest:.2e}"},
                                            {"verdict", "{verdict}: {reason}"},
                                            {"theory", "{theory}"}})},
          {"Iterations until the energy norm of the error is 1e-8 of what it was",
           record::table_of(result.solvers, {{"problem", "{problem}"},
                                             {"divisions", "{divisions:d}"},
                                             {"solver", "{solver}"},
                                             {"iterations", "{iterations:d}"},
                                             {"bound", "{iterations_bound:.0f}"},
                                             {"condition", "{condition:.4g}"},
                                             {"spectral radius", "{spectral_radius:.4f}"},
                                             {"rate", "{rate:.4f}"},
                                             {"rate bound", "{rate_bound:.4f}"},
                                             {"status", "{status}: {detail}"}})},
          {"Errors of solvers that stop early",
           record::table_of(result.stopping, {{"solver", "{solver}"},
                                              {"divisions", "{divisions:d}"},
                                              {"residual", "{tolerance:.0e}"},
                                              {"iterations", "{iterations:d}"},
                                              {"of the solver", "{error_algebraic:.2e}"},
                                              {"of the mesh", "{error_discretisation:.2e}"},
                                              {"both, measured", "{error_total:.2e}"}})},
          {"Times to a residual of 1e-8",
           record::table_of(result.times, {{"solver", "{solver}"},
                                           {"unknowns", "{unknowns:d}"},
                                           {"iterations", "{iterations:d}"},
                                           {"set-up, ns", "{setup_ns_min:.3g}"},
                                           {"solve, ns", "{solve_ns_min:.3g}"},
                                           {"median, ns", "{solve_ns_median:.3g}"},
                                           {"residual", "{residual:.1e}"},
                                           {"status", "{status}: {detail}"}})}};
}

}  // namespace

std::string elements_table(const ElementsResult& result) {
  std::string text;
  for (const TitledTable& each : tables_of(result))
    if (!each.table.rows.empty()) text += each.title + "\n\n" + each.table.text() + "\n";
  return text;
}

std::unique_ptr<Study> make_elements() {
  return make_study<ElementsResult>(
      {.name = "elements",
       .help = "linear finite elements: error against mesh size, and linear solvers",
       .place = 78,
       .cases_help = "",
       .options = {{.name = "most",
                    .help = "divisions of a unit length in the finest mesh, of which the "
                            "largest power of two is taken; default: 128",
                    .least = 16,
                    .most = 1024,
                    .whole = true}}},
      {.measure = measure_elements, .table = elements_table});
}

}  // namespace odeum::study
