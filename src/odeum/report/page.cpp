// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "odeum/report/chart.hpp"
#include "odeum/report/columns.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/markdown.hpp"
#include "odeum/report/texts.hpp"

namespace odeum::report {
namespace {

/// A name that `taken` does not hold: `stem`, or `stem` and a number.
std::string unused_name(std::set<std::string>& taken, const std::string& stem,
                        const std::string& extension) {
  std::string name = stem + extension;
  for (int number = 2; !taken.insert(name).second; ++number)
    name = fmt::format("{}_{}{}", stem, number, extension);
  return name;
}

std::vector<Section> in_order(std::vector<Section> sections) {
  std::stable_sort(sections.begin(), sections.end(),
                   [](const Section& a, const Section& b) { return a.place < b.place; });
  return sections;
}

std::string name_in_links(const Section& section) {
  return escape(section.short_title.empty() ? section.title : section.short_title);
}

std::string html_of(const std::vector<Section>& sections) {
  std::string html;
  for (const Section& section : sections)
    html += fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", section.id,
                        escape(section.title), section.html);
  return html;
}

// From case to case, in the order of the list of cases.
std::string neighbours(const std::vector<CaseFacts>& cases, std::size_t index) {
  const auto link = [&](std::size_t i, const char* arrow) {
    return fmt::format("<a href=\"../{}\">{}{}</a>", as_address(cases[i].file), arrow,
                       escape(cases[i].id));
  };
  std::string html = "<nav aria-label=\"neighbouring cases\">";
  if (index > 0) html += link(index - 1, "← ");
  if (index + 1 < cases.size()) html += link(index + 1, "→ ");
  return html + "</nav>\n";
}

}  // namespace

Page::Page(Facts facts, const record::OutputFolder& folder)
    : facts_(std::move(facts)),
      folder_(folder),
      case_parts_(facts_.cases.size()),
      case_facts_(facts_.cases.size()),
      case_data_(facts_.cases.size()) {
  std::set<std::string> taken;
  for (CaseFacts& c : facts_.cases)
    c.file = unused_name(taken, "cases/" + file_stem(c.id), ".html");
}

void Page::case_part(std::size_t index, Section part) {
  case_parts_.at(index).push_back(std::move(part));
}

void Page::case_fact(std::size_t index, std::string_view name, std::string_view markup) {
  case_facts_.at(index) += fmt::format("<dt>{}</dt><dd>{}</dd>", escape(name), markup);
}

void Page::case_data(std::size_t index, const std::string& name, std::string json) {
  case_data_.at(index)[name] = std::move(json);
}

std::string Page::picture(const std::string& stem, std::string_view png,
                          std::string_view description, std::string_view attributes) {
  const std::string file = unused_name(pictures_, stem, ".png");
  folder_.write(file, png);
  // Lazily: there are hundreds, each a file.
  return fmt::format("<img loading=\"lazy\" alt=\"{}\" src=\"{}\"{}>", escape(description),
                     as_address(file), attributes);
}

void Page::count_row(const std::string& status, const std::string& reason) {
  ++statuses_[status];
  if (!reason.empty()) ++reasons_[reason];
}

void Page::manifest(const std::string& key, const nlohmann::ordered_json& value) {
  manifest_[key] = value.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string Page::navigation(const std::string& root, const std::string& here) const {
  const auto link = [&](const std::string& address, const std::string& text) {
    return fmt::format("<a href=\"{}{}\"{}>{}</a>", root, address,
                       address == here ? " aria-current=\"page\"" : "", text);
  };
  std::string pages;
  for (const Section& section : in_order(sections_))
    pages += link(section.id + ".html", name_in_links(section));
  return fmt::format(
      "<header class=\"top\">\n{5}<a class=\"brand\" href=\"{0}index.html\">Odeum</a>{6}\n"
      "<nav class=\"main\" aria-label=\"views\"><a href=\"{0}index.html#answers\">Answers</a>"
      "<a href=\"{0}index.html#compare\">Compare</a>"
      "<a href=\"{0}index.html#regions\">Stability</a>"
      "<a href=\"{0}index.html#methods\">Methods</a>{1}{2}{3}</nav>\n"
      "<nav class=\"pages\" aria-label=\"tables\">{4}</nav>\n</header>\n",
      root, link("trade-offs.html", "Trade-offs"), link("findings.html", "Findings"),
      link("data.html", "Data"), pages,
      // The page of a case has its own title.
      root.empty() ? "<h1>" : "", root.empty() ? "</h1>" : "");
}

std::string Page::document(const std::string& title, const std::string& top,
                           const std::string& main, const std::vector<std::string>& scripts) {
  std::string loads;
  for (const std::string& script : scripts)
    loads += fmt::format("<script src=\"{}\" defer></script>\n", as_address(script));
  // 'self' of a page that is opened from a disk is nothing in some browsers, hence file:.
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src 'self' "
      "file:; style-src 'unsafe-inline'; script-src 'self' file:; base-uri 'none'; form-action "
      "'none'\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n<title>{}</title>\n"
      "<style>\n{}</style>\n{}</head>\n<body>\n{}{}<main>\n{}</main>\n</body>\n</html>\n",
      escape(title), page_style(), loads, marker_symbols(), top, main);
}

std::string Page::case_page(std::size_t index) const {
  const CaseFacts& c = facts_.cases[index];
  const std::vector<Section> parts = in_order(case_parts_[index]);
  std::string links;
  for (const Section& part : parts)
    links += fmt::format("<a href=\"#{}\">{}</a>", part.id, name_in_links(part));
  const std::string floor =
      c.truth_floor > 0 ? fmt::format(" (known to {})", show_number(c.truth_floor)) : "";
  return document(
      c.id + " – Odeum report", navigation("../", ""),
      neighbours(facts_.cases, index) +
          fmt::format("<h1>{}</h1>\n<p class=\"lead\"><code>{}</code></p>\n<dl class=\"facts\">"
                      "<dt>Equation</dt><dd><code>{}</code></dd><dt>Source</dt><dd>{}</dd>"
                      "<dt>Truth</dt><dd>{}{}</dd>{}</dl>\n<nav "
                      "aria-label=\"on this page\">{}</nav>\n",
                      escape(c.title), escape(c.id), escape(c.equation), escape(c.source),
                      escape(c.truth), floor, case_facts_[index], links) +
          html_of(parts));
}

void Page::write_data(const std::string& file, const Data& data) const {
  std::string json;
  for (const auto& [name, value] : data)
    json += fmt::format("{}\"{}\":{}", json.empty() ? "" : ",", name, value);
  folder_.write("data/" + file + ".js", data_script(file, "{" + json + "}"));
}

void Page::write(const RunFacts& run) {
  for (std::size_t i = 0; i < facts_.cases.size(); ++i)
    folder_.write(facts_.cases[i].file, case_page(i));
  for (const Section& section : sections_)
    folder_.write(section.id + ".html",
                  document(section.title + " – Odeum report", navigation("", section.id + ".html"),
                           html_of({section})));
  const auto prose = [&](const std::string& id, const std::string& title, std::string_view text) {
    folder_.write(id + ".html", document(title + " – Odeum report", navigation("", id + ".html"),
                                         "<section id=\"" + id + "\" class=\"prose\">\n" +
                                             markdown_to_html(text) + "</section>\n"));
  };
  prose("findings", "Findings", findings());
  prose("trade-offs", "Trade-offs", trade_offs());
  prose("columns", "Columns of the files", columns_text());
  write_all_data(run);
  folder_.write("viewer/page.js", page_js());
  folder_.write("manifest.json", manifest_text(run));  // first: data.html links to it
  folder_.write("data.html", data_page(run));
  folder_.write("index.html", index_page(run));
}

std::string data_name(const CaseFacts& c) {
  return "case_" + std::filesystem::path(c.file).stem().string();
}

std::string case_link(const CaseFacts& c, std::string_view section) {
  return fmt::format("<a href=\"{}{}{}\"><code>{}</code></a>", as_address(c.file),
                     section.empty() ? "" : "#", section, escape(c.id));
}

}  // namespace odeum::report
