// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <map>

#include "odeum/fem/field_files.hpp"
#include "odeum/record/table.hpp"
#include "odeum/report/chart.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/page.hpp"
#include "odeum/studies/elements/rows.hpp"

namespace odeum::study {
namespace {

std::string error_chart(const std::vector<ElementsRow>& rows) {
  report::Curves curves;
  for (const ElementsRow& row : rows)
    if (row.status == "ok" && row.h1 > 0 && row.rule == "degree_5")
      curves[row.problem].emplace_back(row.h, row.h1);
  return report::figure_of(
      curves, {.x = "longest edge h", .y = "H1 error", .description = "H1 error against h"}, 1.1,
      {.slopes = {1, 2}});
}

std::string stopping_chart(const std::vector<ElementsStoppingRow>& rows) {
  report::Curves curves;
  double level = unknown_number;
  for (const ElementsStoppingRow& row : rows) {
    curves[row.solver].emplace_back(row.iterations, row.total);
    level = row.discretisation;
  }
  return report::figure_of(
      curves,
      {.x = "iterations",
       .y = "H1 error",
       .description = "H1 error of what a solver gives against its iterations"},
      1.1, {.level = level, .level_text = "error of the mesh"});
}

/// By solver: the loosest residual at which the error is the mesh's to a hundredth.
std::string enough(const std::vector<ElementsStoppingRow>& rows) {
  std::map<std::string, const ElementsStoppingRow*> loosest, tightest;
  for (const ElementsStoppingRow& row : rows) {
    if (row.total <= 1.01 * row.discretisation) loosest.try_emplace(row.solver, &row);
    tightest[row.solver] = &row;
  }
  std::string text;
  for (const auto& [solver, row] : loosest)
    text += fmt::format("{}{}: a residual of {:.0e}, {} iterations instead of {} for {:.0e}",
                        text.empty() ? "" : "; ", solver, row->tolerance, row->iterations,
                        tightest[solver]->iterations, tightest[solver]->tolerance);
  return text;
}

/// Each problem's solution and error, from the rows of its triangles, which follow one another.
std::string pictures(const std::vector<ElementsFieldRow>& rows) {
  std::string html;
  for (std::size_t first = 0, end = 0; first < rows.size(); first = end) {
    fem::TriangleMesh mesh;
    std::vector<double> solution, error;
    for (; end < rows.size() && rows[end].problem == rows[first].problem; ++end) {
      const std::size_t node = mesh.nodes.size();
      mesh.triangles.push_back({node, node + 1, node + 2});
      for (std::size_t k = 0; k < 3; ++k) {
        mesh.nodes.push_back({rows[end].x[k], rows[end].y[k]});
        solution.push_back(rows[end].u[k]), error.push_back(rows[end].error[k]);
      }
    }
    const std::string& name = rows[first].problem;
    html += "<figure>" + fem::field_picture(mesh, solution, report::escape(name) + ": solution") +
            fem::field_picture(mesh, error, report::escape(name) + ": error at the nodes") +
            "</figure>\n";
  }
  return html;
}

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

void add_section(report::Page& page, const ElementsResult& result, const Origin& origin) {
  std::string html = origin_text(origin, result.orders.empty());
  if (!result.orders.empty()) {
    html +=
        "<p>−div(a grad u) = f by linear elements on triangles, against known solutions: orders in "
        "the mesh size with the verdicts of time steps. At the L shape’s reentrant corner the "
        "gradient is infinite, and theory gives 2/3 and 4/3 in place of 1 and 2.</p>\n" +
        error_chart(result.meshes) +
        "<p>Solutions and errors on coarse meshes; a triangle tells its value when pointed "
        "at.</p>\n" +
        pictures(result.fields) +
        "<p>The systems’ solvers, own ones and peers, beside the textbook bound of their rate. M "
        "is the preconditioner; condition: the highest over the lowest eigenvalue of M⁻¹A, by "
        "Lanczos’ process. No bound stands beside peers, which show no spectrum.</p>\n" +
        stopping_chart(result.stopping);
    if (const std::string text = enough(result.stopping); !text.empty())
      html +=
          "<p>A system need not be solved further than its mesh’s error. Within 1 % of that "
          "in the H1 norm: " +
          text + ".</p>\n";
    for (const TitledTable& each : tables_of(result))
      if (!each.table.rows.empty())
        html += report::details(each.title, report::html_of(each.table));
  }
  page.section({.id = "elements", .title = "Finite elements", .place = origin.place, .html = html});
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
      {.measure = measure_elements, .table = elements_table, .section = add_section});
}

}  // namespace odeum::study
