// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/page.hpp"

#include <fmt/format.h>

#include <thread>

#include "odeum/report/html.hpp"
#include "odeum/report/manifest.hpp"
#include "odeum/report/page_sections.hpp"
#include "odeum/report/summary.hpp"
#include "odeum/report/texts.hpp"

namespace odeum::report {
namespace {

constexpr char mark_begin = '\x01', mark_end = '\x02';

std::string image_html(const Picture& picture, const std::string& image,
                       const std::string& description) {
  if (image.empty()) return "<p class=\"missing\">not drawn</p>";
  if (picture.kind == Picture::Kind::svg) return tidy_svg(image, description);
  return fmt::format("<img width=\"{}\" height=\"{}\" alt=\"{}\" src=\"data:image/png;base64,{}\">",
                     picture.width, picture.height, escape(description), base64(image));
}

// What the page and the manifest say about the pictures.
std::string plots_text(const Rendering& rendering) {
  if (rendering.images.empty()) return "none to draw";
  if (rendering.problem.empty()) return "drawn by gnuplot " + rendering.version;
  return (rendering.version.empty() ? "no plots: " : "some plots are missing: ") +
         rendering.problem;
}

}  // namespace

std::string PictureBook::add(Picture picture, std::string description) {
  pictures_.push_back(std::move(picture));
  descriptions_.push_back(std::move(description));
  return fmt::format("{}{}{}", mark_begin, pictures_.size() - 1, mark_end);
}

std::string PictureBook::fill(const std::string& html) const {
  std::string filled;
  std::size_t begin = 0;
  for (std::size_t at; (at = html.find(mark_begin, begin)) != std::string::npos;) {
    const auto end = html.find(mark_end, at);
    const std::size_t i = std::stoul(html.substr(at + 1, end - at - 1));
    filled.append(html, begin, at - begin);
    filled += image_html(pictures_[i], rendering_.images[i], descriptions_[i]);
    begin = end + 1;
  }
  return filled.append(html, begin);
}

Lookup::Lookup(const ReportData& data) {
  const auto key = [](const auto& row) {
    return Key(row.case_id, row.library + "/" + row.solver, row.mode);
  };
  for (const auto& row : data.convergence.orders) orders_[key(row)] = &row;
  for (const auto& row : data.convergence.rows) rows_[key(row)].push_back(&row);
  for (const auto& row : data.convergence.times) times_[key(row)].push_back(&row);
}

const study::OrderRow* Lookup::order(const std::string& case_id, const SolverInfo& solver,
                                     Mode mode) const {
  const auto found = orders_.find(Key(case_id, solver.id(), mode));
  return found == orders_.end() ? nullptr : found->second;
}

const Lookup::Rows<study::ConvergenceRow>& Lookup::rows(const std::string& case_id,
                                                        const SolverInfo& solver, Mode mode) const {
  static const Rows<study::ConvergenceRow> none;
  const auto found = rows_.find(Key(case_id, solver.id(), mode));
  return found == rows_.end() ? none : found->second;
}

const Lookup::Rows<study::TimeRow>& Lookup::times(const std::string& case_id,
                                                  const SolverInfo& solver, Mode mode) const {
  static const Rows<study::TimeRow> none;
  const auto found = times_.find(Key(case_id, solver.id(), mode));
  return found == times_.end() ? none : found->second;
}

std::string case_anchor(std::size_t index) { return fmt::format("case-{}", index); }

std::string verdict_chip(study::Verdict verdict) {
  return fmt::format("<span class=\"chip {0}\">{1} {0}</span>", study::to_string(verdict),
                     style_of(verdict).glyph);
}

std::string legend(const Panel& panel, const std::vector<bool>& shown) {
  std::string html = "<ul class=\"legend\">";
  for (std::size_t i = 0; i < panel.solvers.size(); ++i)
    if (shown[i])
      html += fmt::format(
          "<li><svg viewBox=\"-9 -5 18 10\" style=\"color:var(--s{0})\" aria-hidden=\"true\">"
          "<path d=\"M-9 0H9\" stroke=\"currentColor\"/><use href=\"#m{0}\"/></svg>{1}</li>",
          i, escape(panel.solvers[i]->method));
  return html + "</ul>";
}

void write_page(const ReportData& data, const OutputFolder& folder) {
  PageContext page{.data = data,
                   .folder = folder,
                   .lookup = Lookup(data),
                   .panels = make_panels(data.solvers),
                   .pictures = {}};
  std::string body = overview_section(page) + cases_section(page) + cloth_section(page) +
                     stability_section(page) + proofs_section(page) + verdicts_section(page) +
                     skipped_section(page) + findings_section();
  page.pictures.draw(std::max(1U, std::thread::hardware_concurrency()));
  const std::string plots = plots_text(page.pictures.rendering());
  folder.write("manifest.json", manifest_json(data, plots));  // first: the page links to it
  const std::string head = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>Odeum report</title>\n"
      "<style>\n{}</style>\n</head>\n<body>\n{}",
      page_style(), marker_symbols());
  folder.write("index.html", head + head_section(page, plots) + "<main>\n" +
                                 page.pictures.fill(body) + "</main>\n</body>\n</html>\n");
}

}  // namespace odeum::report
