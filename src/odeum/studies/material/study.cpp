// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/record/table.hpp"
#include "odeum/report/html.hpp"
#include "odeum/studies/material/material.hpp"
#include "odeum/studies/material/section.hpp"

namespace odeum::study {
namespace {

using report::Cell;
using report::show_number;

template <class Row, class Of>
auto in_order(const std::vector<Row>& rows, Of&& of) {
  std::vector<decltype(of(rows.front()))> found;
  for (const Row& row : rows)
    if (std::find(found.begin(), found.end(), of(row)) == found.end()) found.push_back(of(row));
  return found;
}

struct Quantity {
  const char* title;
  double (*of)(const MaterialRow&);
  double (*size)(double value);  ///< how far it is from where it should be, with its sign
  double slight, strong, extreme;
  const char* unit;
};

double octaves(double ratio) { return ratio > 0 ? std::log2(ratio) : 10; }

constexpr Quantity quantities[] = {
    {"Stiffness at rest under gravity, over the nominal one",
     [](const MaterialRow& row) { return row.static_stiffness_ratio; }, octaves, 0.07, 0.4, 1, "×"},
    {"Stiffness of the slowest vibration, over the nominal one",
     [](const MaterialRow& row) { return row.dynamic_stiffness_ratio; }, octaves, 0.07, 0.4, 1,
     "×"},
    {"Damping ratio that the step adds to the nominal one",
     [](const MaterialRow& row) { return row.added_damping_ratio; },
     [](double value) { return value; }, 0.005, 0.05, 0.2, ""}};

Cell response_cell(const MaterialRow& row, const Quantity& quantity) {
  const double value = quantity.of(row);
  const std::string title =
      fmt::format("{}, h = {}, phase {:.2g} a step{}{}", competitor(row), show_step(row.step),
                  row.phase, row.detail.empty() ? "" : ": ", row.detail);
  if (std::isnan(value))
    return {.text = row.status == "unstable" ? "unstable" : "–", .style = "dim", .title = title};
  return {.text = !quantity.unit[0]         ? fmt::format("{:+.2g}", value)
                  : std::abs(value) >= 1000 ? fmt::format("{:.0f}{}", value, quantity.unit)
                                            : show_number(value) + quantity.unit,
          .style = shade(quantity.size(value), quantity.slight, quantity.strong, quantity.extreme),
          .title = title};
}

std::string response_table(const std::vector<MaterialRow>& rows, const Quantity& quantity) {
  report::Table table("numbers tolerances");
  const auto steps = in_order(rows, [](const MaterialRow& row) { return row.step; });
  std::vector<Cell> head{{"solver"}};
  for (const double step : steps) head.push_back({show_step(step)});
  table.head(head);
  for (const std::string& who : in_order(rows, competitor<MaterialRow>)) {
    std::vector<Cell> cells;
    for (const double step : steps)
      for (const MaterialRow& row : rows)
        if (row.step == step && competitor(row) == who)
          cells.push_back(response_cell(row, quantity));
    table.row({who}, cells);
  }
  return fmt::format("<h5>{}</h5>\n", quantity.title) + table.html();
}

Cell part_cell(double value, double left, bool largest) {
  if (std::isnan(value)) return {.text = "–", .style = "dim"};
  const bool known = !(left > value / 2);
  return {.text = (known ? "" : "≲ ") + show_number(known ? value : std::max(value, left), 2),
          .style = largest ? "t2" : "",
          .title = std::isnan(left) ? "" : fmt::format("its limit is known to {:.1g} m", left)};
}

void add_parts(std::vector<Cell>& cells, const ErrorPartsRow& row) {
  if (row.status != "ok") {
    cells.push_back({.text = row.status, .style = "dim", .title = row.detail, .columns = 4});
    return;
  }
  const double most = std::max({row.iteration, row.time_step, row.model});
  cells.push_back({.markup = "<b>" + show_number(row.total, 2) + "</b>"});
  cells.push_back(row.iteration == 0
                      ? Cell{.text = "–", .style = "dim"}
                      : part_cell(row.iteration, row.iteration_left, row.iteration == most));
  cells.push_back(part_cell(row.time_step, row.step_left, row.time_step == most));
  cells.push_back(part_cell(row.model, row.step_left, row.model == most));
}

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

std::string shade(double signed_size, double slight, double strong, double extreme) {
  const double size = std::abs(signed_size);
  const int level = size >= extreme ? 3 : size >= strong ? 2 : size >= slight ? 1 : 0;
  return level == 0 ? "" : fmt::format("t{}{}", signed_size < 0 ? "-" : "", level);
}

std::string show_step(double seconds) {
  const double parts = 1 / seconds;
  if (std::abs(parts - std::round(parts)) < 1e-9 * parts && parts > 1.5)
    return fmt::format("1/{:.0f} s", parts);
  return show_number(seconds) + " s";
}

std::string response_tables(const std::vector<MaterialRow>& rows) {
  if (rows.empty()) return {};
  std::string html =
      "<h3>Effective stiffness and damping</h3>\n"
      "<p>Springs of known stiffness (1000 N/m) and damping (1 N s/m) carry masses of 0.1 kg, hung "
      "by their own weight, which then oscillate with a small amplitude. From the static "
      "deflection "
      "and the oscillation follow the stiffness and the damping that a solver shows at each step, "
      "whatever it was given. An engine's iterations are sweeps over its links, or at most so many "
      "iterations of conjugate gradients (deformable bodies) or of Newton's method; without a "
      "number, the engine's default: one sweep, or one Newton iteration and enough conjugate "
      "gradients.</p>\n"
      "<p>1× and +0 are right. Blue is too soft, orange too stiff or too damped; \"unstable\" "
      "grows without bound, – could not be measured: the tooltip of a cell gives the reason. A "
      "negative static stiffness is a mass that hangs above its place without gravity.</p>\n";
  const std::pair<const char*, const char*> scenes[] = {
      {"one_mass", "One mass on one spring (100 rad/s, damping ratio 0.05)"},
      {"hanging_chain", "A hanging chain of ten (slowest mode 14.9 rad/s, damping ratio 0.0075)"}};
  for (const auto& [scene, title] : scenes) {
    std::vector<MaterialRow> chosen;
    for (const MaterialRow& row : rows)
      if (row.scene == scene && row.status != "not_applicable" &&
          // On one spring the number of sweeps changes nothing, but from one to two with kLST = 1.
          (row.scene != "one_mass" || row.sweeps + row.newton == 0))
        chosen.push_back(row);
    if (chosen.empty()) continue;
    std::string tables;
    for (const Quantity& quantity : quantities) tables += response_table(chosen, quantity);
    html += report::details(fmt::format("<strong>{}</strong>", title), tables,
                            chosen.front().scene == "hanging_chain");
  }
  return html;
}

std::string error_parts_table(const std::vector<ErrorPartsRow>& rows) {
  if (rows.empty()) return {};
  constexpr double shown[] = {0.0125, 0.003125, 0.00078125};
  report::Table table("numbers tolerances parts");
  std::vector<Cell> steps{{.text = "solver", .rows = 2}}, parts;
  for (const double step : shown) {
    steps.push_back({.text = "h = " + show_step(step), .columns = 4});
    parts.insert(parts.end(), {{"total"}, {"iterations"}, {"step"}, {"model"}});
  }
  table.head(steps);
  table.head(parts);
  for (const std::string& who : in_order(rows, competitor<ErrorPartsRow>)) {
    std::vector<Cell> cells;
    for (const double step : shown)
      for (const ErrorPartsRow& row : rows)
        if (std::abs(row.step - step) < 1e-9 && competitor(row) == who) add_parts(cells, row);
    if (!cells.empty()) table.row({who}, cells);
  }
  return fmt::format(
             "<h3>Where the error of a cloth comes from</h3>\n<p>The cloth of 11 x 11 particles at "
             "t = {} s: RMS distance of a particle, in m. <strong>Iterations</strong>: to the same "
             "run with many more of them; <strong>step</strong>: from there to the limit h → 0, "
             "extrapolated from the three finest runs; <strong>model</strong>: from that limit to "
             "the truth, which no step and no iteration reduces. Errors may cancel: the total is "
             "at "
             "most the sum. The largest part is coloured; \"≲\" marks a part that is smaller than "
             "the uncertainty of its limit.</p>\n<p>The model of Bullet's links is another spring "
             "law, and has no damping between free particles; with kLST = 1 it has no stiffness at "
             "all.</p>\n",
             show_number(rows.front().time)) +
         table.html();
}

void add_section(report::Page& page, const MaterialResult& result, const Origin& origin) {
  page.section({.id = "material",
                .title = "What an engine does to the material",
                .place = origin.place,
                .html = origin_text(origin, record::is_empty(result)) +
                        response_tables(result.material) + error_parts_table(result.errors) +
                        long_run_table(result.long_run) + cloth_cost_table(result.cost) +
                        implicit_wins_table(result.implicit_wins),
                .short_title = "Material"});
}

// It takes a quarter of a minute: a quick report shows the rows of an earlier one.
std::unique_ptr<Study> make_material() {
  return make_study<MaterialResult>(
      {.name = "material",
       .help = "effective stiffness and damping of engines, cloth errors and costs",
       .place = 70,
       .cases_help = ""},
      {.measure = measure_material, .table = table, .section = add_section});
}

}  // namespace odeum::study
