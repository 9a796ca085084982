// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/old_page.hpp"

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

std::string image_html(const Picture& picture, const std::string& image, const std::string& file,
                       const std::string& description) {
  if (image.empty()) return "<p class=\"missing\">not drawn</p>";
  if (picture.kind == Picture::Kind::svg) return tidy_svg(image, description);
  // Lazily: there are hundreds, each a file.
  return fmt::format("<img loading=\"lazy\" width=\"{}\" height=\"{}\" alt=\"{}\" src=\"{}\">",
                     picture.width, picture.height, escape(description), as_address(file));
}

// What the page and the manifest say about the pictures.
std::string plots_text(const Rendering& rendering) {
  if (rendering.images.empty()) return "none to draw";
  if (rendering.problem.empty()) return "drawn by gnuplot " + rendering.version;
  return (rendering.version.empty() ? "no plots: " : "some plots are missing: ") +
         rendering.problem;
}

}  // namespace

std::string PictureBook::add(Picture picture, std::string description, const std::string& stem) {
  std::string file;
  if (picture.kind == Picture::Kind::png) {
    file = stem + ".png";
    for (int number = 2; !taken_.insert(file).second; ++number)
      file = fmt::format("{}_{}.png", stem, number);
  }
  files_.push_back(std::move(file));
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
    filled += image_html(pictures_[i], rendering_.images[i], files_[i], descriptions_[i]);
    begin = end + 1;
  }
  return filled.append(html, begin);
}

void PictureBook::write_files(const record::OutputFolder& folder) const {
  for (std::size_t i = 0; i < pictures_.size(); ++i)
    if (!files_[i].empty() && !rendering_.images[i].empty())
      folder.write(files_[i], rendering_.images[i]);
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

std::string PageContext::case_address(std::size_t index) const {
  return as_address(case_files[index]);
}

std::string verdict_bar(const VerdictCounts& counts) {
  std::string bar;
  for (const VerdictStyle& style : verdict_styles)
    if (const std::size_t count = counts[static_cast<std::size_t>(style.verdict)];
        count > 0 && style.verdict != judge::Verdict::not_applicable)
      bar += fmt::format("<i class=\"{}\" style=\"flex-grow:{}\"></i>", to_string(style.verdict),
                         count);
  return "<span class=\"bar\" aria-hidden=\"true\">" + bar + "</span>";
}

std::string verdict_words(const VerdictCounts& counts) {
  std::string words;
  for (const VerdictStyle& style : verdict_styles)
    if (const std::size_t count = counts[static_cast<std::size_t>(style.verdict)];
        count > 0 && style.verdict != judge::Verdict::not_applicable)
      words += fmt::format("{}{} {}", words.empty() ? "" : ", ", count, to_string(style.verdict));
  return words.empty() ? "not run" : words;
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

namespace {

// A whole page around its header and main part.
std::string document(const std::string& title, const std::string& header, const std::string& main) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n"
      "<style>\n{}</style>\n</head>\n<body>\n{}{}<main>\n{}</main>\n</body>\n</html>\n",
      escape(title), page_style(), marker_symbols(), header, main);
}

std::vector<std::string> name_case_files(const std::vector<CaseFacts>& cases) {
  std::vector<std::string> files;
  std::set<std::string> taken;
  for (const CaseFacts& c : cases) {
    const std::string stem = "cases/" + file_stem(c.id);
    std::string file = stem + ".html";
    for (int number = 2; !taken.insert(file).second; ++number)
      file = fmt::format("{}_{}.html", stem, number);
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace

void write_page(const ReportData& data, const record::OutputFolder& folder) {
  PageContext page{.data = data,
                   .folder = folder,
                   .lookup = Lookup(data),
                   .panels = make_panels(data.solvers),
                   .case_files = name_case_files(data.cases),
                   .pictures = {}};
  const std::string body = overview_section(page) + precision_section(page) + orders_section(page) +
                           stability_section(page) + hard_cases_section(page) +
                           material_section(page) + proofs_section(page) + verdicts_section(page) +
                           skipped_section(page) + findings_section();
  std::vector<std::string> bodies;
  for (std::size_t i = 0; i < data.cases.size(); ++i) bodies.push_back(case_body(page, i));
  page.pictures.draw(std::max(1U, std::thread::hardware_concurrency()));
  const std::string plots = plots_text(page.pictures.rendering());
  page.pictures.write_files(folder);
  for (std::size_t i = 0; i < data.cases.size(); ++i)
    folder.write(page.case_files[i],
                 document(data.cases[i].id + " – Odeum report", "", page.pictures.fill(bodies[i])));
  folder.write("manifest.json", manifest_json(data, plots));  // first: the page links to it
  folder.write("index.html",
               document("Odeum report", head_section(page, plots), page.pictures.fill(body)));
}

}  // namespace odeum::report
