// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/table.hpp"

#include <fmt/format.h>

#include "odeum/report/html.hpp"

namespace odeum::report {
namespace {

std::string attribute(const char* name, std::string_view value) {
  return value.empty() ? "" : fmt::format(" {}=\"{}\"", name, escape(value));
}

std::string span(const char* name, std::size_t count) {
  return count == 1 ? "" : fmt::format(" {}=\"{}\"", name, count);
}

std::string element(const char* tag, const Cell& cell) {
  return fmt::format("<{0}{1}{2}{3}{4}>{5}</{0}>", tag, span("colspan", cell.columns),
                     span("rowspan", cell.rows), attribute("class", cell.style),
                     attribute("title", cell.title),
                     cell.markup.empty() ? escape(cell.text) : cell.markup);
}

}  // namespace

void Table::head(const std::vector<Cell>& cells) {
  head_ += "<tr>";
  for (const Cell& cell : cells) head_ += element("th", cell);
  head_ += "</tr>\n";
}

void Table::row(const Cell& name, const std::vector<Cell>& cells, std::string_view style) {
  body_ += "<tr" + attribute("class", style) + ">" + element("th", name);
  for (const Cell& cell : cells) body_ += element("td", cell);
  body_ += "</tr>\n";
  ++rows_;
}

std::string Table::html() const {
  if (rows_ == 0) return {};
  return "<div class=\"wide\"><table" + attribute("class", style_) + "><thead>" + head_ +
         "</thead><tbody>\n" + body_ + "</tbody></table></div>\n";
}

std::string html_of(const record::Table& table, std::string style) {
  Table html(std::move(style));
  std::vector<Cell> head;
  for (const auto& column : table.columns) head.push_back({column.heading});
  html.head(head);
  for (const std::vector<std::string>& row : table.rows) {
    std::vector<Cell> cells;
    for (const std::string& text : row) cells.push_back({text});
    html.row(cells.front(), {cells.begin() + 1, cells.end()});
  }
  return html.html();
}

std::string details(std::string_view summary, std::string_view body, bool open) {
  if (body.empty()) return {};
  return fmt::format("<details{}><summary>{}</summary>\n{}</details>\n", open ? " open" : "",
                     summary, body);
}

}  // namespace odeum::report
