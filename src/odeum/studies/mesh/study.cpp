// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/report/chart.hpp"
#include "odeum/report/page.hpp"
#include "odeum/report/table.hpp"
#include "odeum/studies/mesh/rows.hpp"

namespace odeum::study {
namespace {

std::vector<record::TableColumn> columns() {
  return {{"springs", "{springs}"},
          {"scaling", "{scaling}"},
          {"particles an edge", "{particles:d}"},
          {"stiffness, N/m", "{stiffness:.4g}"},
          {"extension, m", "{extension:.4f}"},
          {"period, s", "{period:.4f}"},
          {"sag, m", "{sag:.4f}"},
          {"drape, m", "{drape:.4f}"},
          {"factor", "{factor:.3f}"},
          {"status", "{status}: {detail}"}};
}

/// A column against the number of particles, a curve for each scaling of the structural springs.
std::string chart_of(const std::vector<MeshRow>& rows, const char* name, double MeshRow::*column) {
  report::Curves curves;
  for (const MeshRow& row : rows)
    if (row.springs == "structural" && row.status == "ok")
      curves[row.scaling].emplace_back(row.particles, row.*column);
  return report::figure_of(curves,
                           {.x = "particles along an edge",
                            .y = name,
                            .description = std::string(name) + " against the number of particles"});
}

std::string table(const MeshResult& result) {
  return record::table_of(result.rows, columns()).text();
}

void add_section(report::Page& page, const MeshResult& result, const Origin& origin) {
  const record::Table rows = record::table_of(result.rows, columns());
  if (rows.rows.empty()) return;
  page.section(
      {.id = "mesh",
       .title = "Mesh influence",
       .place = origin.place,
       .html = "<p>The same square sheet (1 m, 1 kg) as meshes of particles and springs. Factor: "
               "the number by which every stiffness must be multiplied for the extension of the "
               "coarsest mesh. Structural and shear springs keep their stiffness when the mesh is "
               "refined: as many more stand side by side as stand in a row. A stiffness per "
               "length (k ~ 1 / length, as of one thread) makes a finer sheet stiffer, one "
               "divided by the number of springs makes it softer, both in proportion to the "
               "number of particles along an edge. Held by two corners alone, a sheet sags "
               "further with every refinement: a membrane does not carry a load in a point, and no "
               "stiffness "
               "makes up for it.</p>\n" +
               chart_of(result.rows, "factor", &MeshRow::factor) +
               "<p>What the wrong scalings look like: the same sheet under its own weight is "
               "shorter or longer by the mesh alone. The scenes <code>sheet_coarse</code>, "
               "<code>sheet_fine</code> (scaled rightly) and <code>sheet_fine_heavy</code> "
               "(particles of the coarse sheet's mass in the fine one) show it: <code>odeum run "
               "sheet_fine_heavy --out DIR</code> writes a replay.</p>\n" +
               chart_of(result.rows, "extension, m", &MeshRow::extension) + report::html_of(rows)});
}

}  // namespace

std::unique_ptr<Study> make_mesh() {
  return make_study<MeshResult>(
      {.name = "mesh",
       .help = "one square sheet at meshes of 6 x 6 to 96 x 96, and how to scale springs",
       .place = 75,
       .cases_help = "",
       .options = {{.name = "most",
                    .help = "particles along an edge of the finest; default: 96",
                    .least = 6,
                    .most = 192,
                    .whole = true}},
       .report = {{.own = {{"most", "24"}}}}},
      {.measure = measure_mesh, .table = table, .section = add_section});
}

}  // namespace odeum::study
