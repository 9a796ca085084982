// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <map>
#include <thread>

#include "odeum/core/parallel.hpp"
#include "odeum/record/table.hpp"
#include "odeum/report/chart.hpp"
#include "odeum/report/columns.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/page.hpp"
#include "odeum/report/solver_tables.hpp"
#include "odeum/studies/stability/section.hpp"

namespace odeum::study {
namespace {

using report::Cell;
using report::escape;
using report::show_number;

constexpr const char* axes[] = {"real", "imaginary", "oscillator"};

void add_limit(std::vector<Cell>& cells, const StabilityLimit* limit) {
  const bool differs = limit && limit->status == "differs";
  if (!limit)
    cells.insert(cells.end(), 3, Cell());
  else if (limit->status != "ok" && !differs)
    cells.push_back({.text = limit->status, .style = "dim", .title = limit->detail, .columns = 3});
  else
    cells.insert(cells.end(),
                 {{.text = show_number(limit->limit, 8), .title = limit->detail},
                  {.text = show_number(limit->theory, 8), .style = "dim"},
                  {.text = (differs ? "differs: " : "") + show_number(limit->difference, 2),
                   .style = "dim"}});
}

std::string limits_table(const std::vector<StabilityLimit>& limits, const std::string& library) {
  std::map<std::string, std::map<std::string, const StabilityLimit*>> by_solver;
  std::vector<std::string> order;
  for (const StabilityLimit& limit : limits) {
    if (limit.library != library) continue;
    if (!by_solver.contains(limit.solver)) order.push_back(limit.solver);
    by_solver[limit.solver][limit.axis] = &limit;
  }
  report::Table table("numbers limits");
  table.head({{.text = "solver", .rows = 2},
              {.text = "real axis", .columns = 3},
              {.text = "imaginary axis", .columns = 3},
              {.text = "oscillator, ωh", .columns = 3}});
  std::vector<Cell> head;
  for (std::size_t i = 0; i < std::size(axes); ++i)
    head.insert(head.end(), {{"measured"}, {"theory"}, {"difference"}});
  table.head(head);
  for (const std::string& solver : order) {
    std::vector<Cell> cells;
    for (const char* axis : axes) add_limit(cells, by_solver[solver][axis]);
    table.row({solver}, cells);
  }
  return report::details(fmt::format("<strong>{}</strong> <span class=\"dim\">{}</span>",
                                     escape(library), report::show_count(order.size(), "solver")),
                         table.html(), order.size() <= 20);
}

// Axes drawn over the picture, which fills their field.
std::string picture(report::Page& page, const StabilityRegion& region, std::string_view png) {
  const std::string name = fmt::format("{}/{}", region.library, region.solver);
  constexpr report::ChartSize margins{0, 0, 25, 5, 4, 17};
  report::ChartSize size = margins;
  size.width = 230;
  const double field = size.width - size.left - size.right;
  size.height = size.top + field / aspect_of(region) + size.bottom;
  const auto percent = [](double part, double whole) { return 100 * part / whole; };
  const std::string image = page.picture(
      fmt::format("stability/{}_{}_{}", report::file_stem(region.library),
                  report::file_stem(region.solver), region.plane),
      png, fmt::format("Stability region of {}, {} plane", name, region.plane),
      fmt::format(" style=\"left:{:.1f}%;top:{:.1f}%;width:{:.1f}%;height:{:.1f}%\"",
                  percent(size.left, size.width), percent(size.top, size.height),
                  percent(field, size.width), percent(field / aspect_of(region), size.height)));
  const report::Chart chart(size, {region.first_low, region.first_high, false},
                            {region.second_low, region.second_high, false},
                            {.x = {}, .y = {}, .description = "Axes of the picture", .x_tick = {}});
  return image + chart.svg();
}

std::string thumbnails(report::Page& page, const std::vector<StabilityRegion>& regions,
                       const std::vector<std::string>& pngs, const std::string& library,
                       const std::string& plane) {
  std::string html;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    const StabilityRegion& region = regions[i];
    if (region.library != library || region.plane != plane) continue;
    html += fmt::format(
        "<figure class=\"region\"><div>{}</div><figcaption>{}</figcaption>"
        "</figure>\n",
        can_be_drawn(region)
            ? picture(page, region, pngs[i])
            : fmt::format("<p class=\"missing\">{}</p>",
                          escape(region.detail.empty() ? region.status : region.detail)),
        escape(region.solver));
  }
  if (html.empty()) return {};
  return fmt::format("<h4>{}</h4>\n<div class=\"regions\">{}</div>\n", escape(library), html);
}

std::string steps_table(const std::vector<StableStep>& steps) {
  report::Table table("numbers");
  table.head({{"case, solver"}, {"largest step"}, {"limiting eigenvalue"}, {"|z| on its ray"}});
  for (const StableStep& row : steps) {
    const std::string name = fmt::format("{}, {}/{}", row.case_id, row.library, row.solver);
    if (row.status != "ok")
      table.row({name}, {{.text = row.status, .style = "dim", .title = row.detail, .columns = 3}});
    else
      table.row({name}, {{.text = show_number(row.step, 4), .title = row.detail},
                         {fmt::format("{} {:+.3g}i", show_number(row.eigenvalue.real(), 4),
                                      row.eigenvalue.imag())},
                         {show_number(row.limit, 5)}});
  }
  return fmt::format(
      "<h3>Largest steps by the spectrum</h3>\n<p>The largest step h for which h times each "
      "eigenvalue of the Jacobian along the solution lies where the running code does not grow; "
      "eigenvalues with a positive real part, where the solution grows itself, are left "
      "out.</p>\n{}",
      table.html());
}

constexpr const char* limits_text =
    "<p>Measured on the running code: the largest x with no growth on [−x, 0], the largest y with "
    "none on [0, iy], and the largest ωh for which an undamped oscillator stays bounded; ∞ where "
    "there is none. Theory comes from the method's own stability function, where it has one.</p>\n";

constexpr const char* regions_text =
    "<p>Shaded: no growth from step to step, the darker the stronger the damping (steps of a "
    "quarter). Orange: the boundary. Grey lines: growth by 1.25 and by 2 a step. Brown: no "
    "result.</p>\n";

constexpr std::pair<const char*, const char*> planes[] = {
    {"lambda", "Regions in the plane of z = λh (real part across, imaginary part up)"},
    {"oscillator", "Regions of the damped oscillator (ωh across, damping ratio ζ up)"}};

std::string table(const StabilityResult& result) {
  std::string text;
  if (!result.steps.empty())
    text = record::table_of(result.steps,
                            {{"case", "{case}"},
                             {"solver", "{library}/{solver}"},
                             {"largest step", "{step:.4g}"},
                             {"by the eigenvalue", "{eigenvalue_re:.3g} {eigenvalue_im:+.3g}i"},
                             {"limit on its ray", "{limit:.5g}"},
                             {"status", "{status}: {detail}"}})
               .text();
  if (result.steps.empty() || !result.limits.empty())
    text += record::table_of(result.limits, {{"solver", "{library}/{solver}"},
                                             {"axis", "{axis}"},
                                             {"limit", "{limit:.7g}"},
                                             {"theory", "{theory:.7g}"},
                                             {"status", "{status}: {detail}"}})
                .text();
  return text;
}

void write_growths(const StabilityResult& result, const record::OutputFolder& folder) {
  parallel_for(result.regions.size(), std::thread::hardware_concurrency(), [&](std::size_t i) {
    if (!result.regions[i].growth.empty()) write_growth(result.regions[i], folder);
  });
}

}  // namespace

void add_section(report::Page& page, const StabilityResult& result, const Origin& origin) {
  const std::vector<std::string> libraries = page.facts().library_names();
  const bool no_regions = result.limits.empty() && result.regions.empty();
  std::string html = origin_text(origin, record::is_empty(result));
  for (const StableStep& row : result.steps) page.count_row(row.status);
  if (!result.steps.empty()) html += steps_table(result.steps);
  if (!no_regions) html += limits_text;
  for (const StabilityLimit& limit : result.limits) page.count_row(limit.status);
  page.data("index", "limits",
            report::columns_of(result.limits,
                               {"library", "solver", "axis", "limit", "theory", "status"}));
  page.data("regions", "regions", outlines_json(result.regions));
  for (const std::string& library : libraries) html += limits_table(result.limits, library);
  std::vector<std::string> pngs(result.regions.size());
  parallel_for(pngs.size(), std::thread::hardware_concurrency(), [&](std::size_t i) {
    if (can_be_drawn(result.regions[i])) pngs[i] = region_png(result.regions[i]);
  });
  for (const auto& [plane, title] : planes) {
    std::string regions;
    for (const std::string& library : libraries)
      regions += thumbnails(page, result.regions, pngs, library, plane);
    if (!regions.empty()) html += fmt::format("<h3>{}</h3>\n{}{}", title, regions_text, regions);
  }
  page.section({.id = "stability", .title = "Stability", .place = origin.place, .html = html});
}

std::unique_ptr<Study> make_stability() {
  return make_study<StabilityResult>(
      {.name = "stability",
       .help = "stability regions and limits, measured on the running code",
       .place = 30,
       .cases_help = "the steps that the regions allow on these cases, with * and ?; "
                     "default: the regions themselves",
       .on_cases = false,
       .options = {{.name = "plane",
                    .help = "lambda or oscillator; default: both",
                    .words = {"lambda", "oscillator"}},
                   {.name = "grid",
                    .help = "points along an axis",
                    .least = 8,
                    .most = 4096,
                    .whole = true},
                   {.name = "peer-grid",
                    .help = "the same for the solvers of other libraries",
                    .least = 8,
                    .most = 4096,
                    .whole = true}},
       .quick_report = {{.own = {{"grid", "65"}, {"peer-grid", "17"}}}}},
      {.measure = measure_stability,
       .table = table,
       .section = add_section,
       .write_more = write_growths});
}

}  // namespace odeum::study
