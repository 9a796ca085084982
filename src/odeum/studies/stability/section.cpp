// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/report/html.hpp"
#include "odeum/report/page_sections.hpp"

namespace odeum::report {
namespace {

using study::StabilityLimit;
using study::StabilityRegion;

constexpr const char* axes[] = {"real", "imaginary", "oscillator"};

std::string limit_cells(const StabilityLimit* limit) {
  if (!limit) return "<td></td><td></td><td></td>";
  const bool differs = limit->status == "differs";
  if (limit->status != "ok" && !differs)
    return fmt::format("<td colspan=\"3\" class=\"dim\" title=\"{}\">{}</td>",
                       escape(limit->detail), escape(limit->status));
  return fmt::format("<td title=\"{}\">{}</td><td class=\"dim\">{}</td><td class=\"dim\">{}{}</td>",
                     escape(limit->detail), show_number(limit->limit, 8),
                     show_number(limit->theory, 8), differs ? "differs: " : "",
                     show_number(limit->difference, 2));
}

std::string limits_table(const ReportData& data, const std::string& library) {
  std::map<std::string, std::map<std::string, const StabilityLimit*>> by_solver;
  std::vector<std::string> order;
  for (const StabilityLimit& limit : data.stability.limits) {
    if (limit.library != library) continue;
    if (!by_solver.contains(limit.solver)) order.push_back(limit.solver);
    by_solver[limit.solver][limit.axis] = &limit;
  }
  if (order.empty()) return {};
  std::string rows;
  for (const std::string& solver : order) {
    rows += fmt::format("<tr><th>{}</th>", escape(solver));
    for (const char* axis : axes) {
      const auto found = by_solver[solver].find(axis);
      rows += limit_cells(found == by_solver[solver].end() ? nullptr : found->second);
    }
    rows += "</tr>\n";
  }
  return fmt::format(
      "<details{}><summary><strong>{}</strong> <span class=\"dim\">{}</span></summary><div "
      "class=\"wide\">"
      "<table class=\"numbers limits\"><thead><tr><th rowspan=\"2\">solver</th>"
      "<th colspan=\"3\">real axis</th><th colspan=\"3\">imaginary axis</th>"
      "<th colspan=\"3\">oscillator, ωh</th></tr><tr>{}</tr></thead><tbody>\n{}</tbody></table>"
      "</div></details>\n",
      order.size() <= 20 ? " open" : "", escape(library), show_count(order.size(), "solver"),
      "<th>measured</th><th>theory</th><th>difference</th><th>measured</th><th>theory</th>"
      "<th>difference</th><th>measured</th><th>theory</th><th>difference</th>",
      rows);
}

bool can_be_drawn(const StabilityRegion& region) {
  return region.columns > 1 && region.rows > 1 && region.first_low < region.first_high &&
         region.second_low < region.second_high &&
         region.growth.size() == static_cast<std::size_t>(region.columns) * region.rows &&
         std::any_of(region.growth.begin(), region.growth.end(),
                     [](float growth) { return std::isfinite(growth); });
}

std::string thumbnails(PageContext& page, const std::string& library, const std::string& plane) {
  std::string html;
  for (const StabilityRegion& region : page.data.stability.regions) {
    if (region.library != library || region.plane != plane) continue;
    const std::string picture =
        can_be_drawn(region)
            ? page.pictures.add(
                  draw(region),
                  fmt::format("Stability region of {}/{}, {} plane", library, region.solver, plane),
                  fmt::format("stability/{}_{}_{}", file_stem(library), file_stem(region.solver),
                              plane))
            : fmt::format("<p class=\"missing\">{}</p>",
                          escape(region.detail.empty() ? region.status : region.detail));
    html += fmt::format("<figure class=\"region\">{}<figcaption>{}</figcaption></figure>\n",
                        picture, escape(region.solver));
  }
  if (html.empty()) return {};
  return fmt::format("<h4>{}</h4>\n<div class=\"regions\">{}</div>\n", escape(library), html);
}

}  // namespace

std::string stability_section(PageContext& page) {
  std::string html =
      "<section id=\"stability\">\n<h2>Stability</h2>\n<p>Measured on the running code: the "
      "largest "
      "x with no growth on [−x, 0], the largest y with none on [0, iy], and the largest ωh for "
      "which "
      "an undamped oscillator stays bounded; ∞ where there is none. Theory comes from the "
      "method's own stability function, where it has one.</p>\n";
  if (page.data.stability.limits.empty() && page.data.stability.regions.empty())
    return html + "<p>Not measured in this run.</p>\n</section>\n";
  for (const std::string& library : library_names(page.data))
    html += limits_table(page.data, library);
  struct Plane {
    const char *id, *title;
  };
  for (const auto& [plane, title] :
       {Plane{"lambda", "Regions in the plane of z = λh (real part across, imaginary part up)"},
        Plane{"oscillator", "Regions of the damped oscillator (ωh across, damping ratio ζ up)"}}) {
    std::string regions;
    for (const std::string& library : library_names(page.data))
      regions += thumbnails(page, library, plane);
    if (!regions.empty())
      html += fmt::format(
          "<h3>{}</h3>\n<p>Shaded: no growth from step to step, the darker the stronger the "
          "damping "
          "(steps of a quarter). Orange: the boundary. Grey lines: growth by 1.25 and by 2 a step. "
          "Brown: no result.</p>\n{}",
          title, regions);
  }
  return html + "</section>\n";
}

}  // namespace odeum::report
