// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/material/section.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/report/html.hpp"
#include "odeum/report/page_sections.hpp"

namespace odeum::report {
namespace {

using study::ErrorPartsRow;
using study::MaterialRow;

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
     [](const MaterialRow& row) { return row.resting; }, octaves, 0.07, 0.4, 1, "×"},
    {"Stiffness of the slowest vibration, over the nominal one",
     [](const MaterialRow& row) { return row.vibrating; }, octaves, 0.07, 0.4, 1, "×"},
    {"Damping ratio that the step adds to the nominal one",
     [](const MaterialRow& row) { return row.added_damping_ratio; },
     [](double value) { return value; }, 0.005, 0.05, 0.2, ""}};

std::string response_cell(const MaterialRow& row, const Quantity& quantity) {
  const double value = quantity.of(row);
  const std::string title =
      fmt::format("{}, h = {}, phase {:.2g} a step{}{}", competitor(row), show_step(row.step),
                  row.phase, row.detail.empty() ? "" : ": ", row.detail);
  if (std::isnan(value))
    return fmt::format(R"(<td class="dim" title="{}">{}</td>)", escape(title),
                       row.status == "unstable" ? "unstable" : "–");
  const std::string text = !quantity.unit[0]         ? fmt::format("{:+.2g}", value)
                           : std::abs(value) >= 1000 ? fmt::format("{:.0f}{}", value, quantity.unit)
                                                     : show_number(value) + quantity.unit;
  return fmt::format(
      R"(<td class="{}" title="{}">{}</td>)",
      shade(quantity.size(value), quantity.slight, quantity.strong, quantity.extreme),
      escape(title), text);
}

std::string response_table(const std::vector<MaterialRow>& rows, const Quantity& quantity) {
  std::string html = fmt::format(
      "<h5>{}</h5>\n<div class=\"wide\"><table class=\"numbers tolerances\"><thead><tr><th>"
      "solver</th>",
      quantity.title);
  const auto steps = in_order(rows, [](const MaterialRow& row) { return row.step; });
  for (const double step : steps) html += "<th>" + show_step(step) + "</th>";
  html += "</tr></thead><tbody>\n";
  for (const std::string& who : in_order(rows, competitor<MaterialRow>)) {
    html += "<tr><th>" + escape(who) + "</th>";
    for (const double step : steps)
      for (const MaterialRow& row : rows)
        if (row.step == step && competitor(row) == who) html += response_cell(row, quantity);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string part_cell(double value, double left, bool largest) {
  if (std::isnan(value)) return "<td class=\"dim\">–</td>";
  const bool known = !(left > value / 2);
  return fmt::format(R"(<td class="{}" title="{}">{}{}</td>)", largest ? "t2" : "",
                     std::isnan(left) ? "" : fmt::format("its limit is known to {:.1g} m", left),
                     known ? "" : "≲ ", show_number(known ? value : std::max(value, left), 2));
}

std::string parts_cells(const ErrorPartsRow& row) {
  if (row.status != "ok")
    return fmt::format(R"(<td colspan="4" class="dim" title="{}">{}</td>)", escape(row.detail),
                       escape(row.status));
  const double most = std::max({row.iteration, row.time_step, row.model});
  return fmt::format("<td><b>{}</b></td>", show_number(row.total, 2)) +
         (row.iteration == 0
              ? "<td class=\"dim\">–</td>"
              : part_cell(row.iteration, row.iteration_left, row.iteration == most)) +
         part_cell(row.time_step, row.step_left, row.time_step == most) +
         part_cell(row.model, row.step_left, row.model == most);
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
      "<h3>Stiffness and damping that come out</h3>\n"
      "<p>Springs of known stiffness (1000 N/m) and damping (1 N s/m) carry masses of 0.1 kg, hung "
      "by their own weight; then they swing a little. From where they rest and how they swing "
      "follow the stiffness and the damping that a solver <em>shows</em> at each step, whatever it "
      "was told. An engine's iterations are sweeps over its links, or iterations of conjugate "
      "gradients at most (deformable bodies), or of Newton's method; without a number: as it "
      "comes, "
      "which is one sweep, or one Newton iteration and enough conjugate gradients.</p>\n"
      "<p>1× and +0 are right. Blue is too soft, orange too stiff or too damped; \"unstable\" "
      "grows without bound, – could not be measured: pointing at a cell says why. A negative "
      "stiffness at rest is a mass that hangs above where it is without gravity.</p>\n";
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
    html += fmt::format("<details{}><summary><strong>{}</strong></summary>\n",
                        chosen.front().scene == "hanging_chain" ? " open" : "", title);
    for (const Quantity& quantity : quantities) html += response_table(chosen, quantity);
    html += "</details>\n";
  }
  return html;
}

std::string error_parts_table(const std::vector<ErrorPartsRow>& rows) {
  if (rows.empty()) return {};
  constexpr double shown[] = {0.0125, 0.003125, 0.00078125};
  std::string html = fmt::format(
      "<h3>Where the error of a cloth comes from</h3>\n<p>The cloth of 11 x 11 particles at t = {} "
      "s: RMS distance of a particle, in m. <strong>Iterations</strong>: to the same run with many "
      "more of them; <strong>step</strong>: from there to the limit h → 0, extrapolated from the "
      "three finest runs; <strong>model</strong>: from that limit to the truth, which no step and "
      "no iteration will mend. Errors may cancel: the total is at most the sum. The largest part "
      "is "
      "coloured; \"≲\" marks a part that is smaller than its limit is known.</p>\n"
      "<p>The model of Bullet's links is another law of springs, and has no damping between free "
      "particles; with kLST = 1 it has no stiffness at all.</p>\n",
      show_number(rows.front().time));
  html +=
      "<div class=\"wide\"><table class=\"numbers tolerances parts\"><thead><tr><th "
      "rowspan=\"2\">solver</th>";
  for (const double step : shown)
    html += fmt::format("<th colspan=\"4\">h = {}</th>", show_step(step));
  html += "</tr><tr>";
  for (std::size_t i = 0; i < std::size(shown); ++i)
    html += "<th>total</th><th>iterations</th><th>step</th><th>model</th>";
  html += "</tr></thead><tbody>\n";
  for (const std::string& who : in_order(rows, competitor<ErrorPartsRow>)) {
    std::string cells;
    for (const double step : shown)
      for (const ErrorPartsRow& row : rows)
        if (std::abs(row.step - step) < 1e-9 && competitor(row) == who) cells += parts_cells(row);
    if (!cells.empty()) html += "<tr><th>" + escape(who) + "</th>" + cells + "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string material_section(const PageContext& page) {
  const study::MaterialResult& found = page.data.material;
  std::string html = "<section id=\"material\">\n<h2>What an engine does to the material</h2>\n";
  if (!found.problem.empty())
    html += fmt::format("<p class=\"missing\">{}</p>\n", escape(found.problem));
  if (found.empty())
    return html +
           "<p>Not measured in this run: a full <code>odeum report</code> measures it, or "
           "<code>odeum material</code> into the same folder.</p>\n</section>\n";
  return html + response_tables(found.material) + error_parts_table(found.errors) +
         long_run_table(found.long_run) + cloth_cost_table(found.cost) +
         implicit_wins_table(found.implicit_wins) + "</section>\n";
}

}  // namespace odeum::report
