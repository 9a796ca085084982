// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace odeum::record {
namespace {

std::string line_of(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths,
                    const std::vector<Table::Column>& columns) {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k)
    line += columns[k].right ? fmt::format("{:>{}}  ", cells[k], widths[k])
                             : fmt::format("{:<{}}  ", cells[k], widths[k]);
  return line.substr(0, line.find_last_not_of(' ') + 1) + '\n';
}

/// One column of a table, which may show several fields.
struct ShownColumn {
  std::string name, format = ".4g";
  std::size_t at = 0;       ///< of the field; of a complex number the first of two
  std::size_t before = at;  ///< of the field whose text stands before it, at: none
  std::size_t behind = at;  ///< likewise behind it
  bool complex = false;
};

ShownColumn column_of(std::string_view word, const Fields& blank) {
  const std::size_t colon = std::min(word.find(':'), word.size());
  ShownColumn column{.name = std::string(word.substr(0, colon))};
  if (colon < word.size()) column.format = word.substr(colon + 1);
  const auto find = [&](const std::string& name) {
    const auto found =
        std::ranges::find_if(blank, [&](const Field& field) { return field.column == name; });
    return static_cast<std::size_t>(found - blank.begin());
  };
  column.at = find(column.name);
  if (column.at == blank.size()) {
    column.at = find(column.name + "_re");
    column.complex = column.at < blank.size();
  }
  if (column.at == blank.size()) throw std::out_of_range("no column " + column.name);
  const auto other = [&](const char* name, const char* its) {
    const std::size_t at = column.name == name ? find(its) : blank.size();
    return at < blank.size() ? at : column.at;
  };
  column.before = other("solver", "library");
  column.behind = column.name == "status" ? other("status", "detail") : other("verdict", "reason");
  return column;
}

std::string number_text(double value, const std::string& format) {
  return std::isnan(value) ? "-" : fmt::format(fmt::runtime("{:" + format + "}"), value);
}

std::string cell_of(const ShownColumn& column, const Fields& row) {
  const Cell& cell = row[column.at].value;
  if (const auto* number = std::get_if<double>(&cell)) {
    if (!column.complex || std::isnan(*number)) return number_text(*number, column.format);
    return fmt::format("{:.3g} {:+.3g}i", *number, std::get<double>(row[column.at + 1].value));
  }
  std::string text = cell_text(cell);
  if (column.before != column.at) text = cell_text(row[column.before].value) + "/" + text;
  const std::string more = column.behind != column.at ? cell_text(row[column.behind].value) : "";
  return more.empty() ? text : text + ": " + more;
}

}  // namespace

std::string Table::text() const {
  // One long cell must not move the columns of two hundred lines off the screen.
  constexpr std::size_t widest = 62;
  std::vector<std::string> headings;
  std::vector<std::size_t> widths;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    headings.push_back(columns[k].heading);
    widths.push_back(headings[k].size());
    for (const auto& row : rows) widths[k] = std::max(widths[k], std::min(row[k].size(), widest));
  }
  std::string text = line_of(headings, widths, columns);
  for (const auto& row : rows) text += line_of(row, widths, columns);
  return text;
}

// The first row is a blank one.
Table detail::make_table(std::string_view columns, const std::vector<Fields>& rows) {
  Table table;
  std::vector<ShownColumn> shown;
  while (!columns.empty()) {
    const std::size_t end = std::min(columns.find(' '), columns.size());
    const ShownColumn& column = shown.emplace_back(column_of(columns.substr(0, end), rows.front()));
    const bool text = std::holds_alternative<std::string>(rows.front()[column.at].value);
    table.columns.push_back({column.name, !text && !column.complex});
    columns.remove_prefix(std::min(end + 1, columns.size()));
  }
  for (auto row = rows.begin() + 1; row != rows.end(); ++row) {
    auto& cells = table.rows.emplace_back();
    for (const ShownColumn& column : shown) cells.push_back(cell_of(column, *row));
  }
  return table;
}

std::string detail::json_text(
    const std::vector<std::pair<std::string, std::vector<Fields>>>& lists) {
  nlohmann::ordered_json all = nlohmann::ordered_json::object();
  for (const auto& [file, rows] : lists) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Fields& row : rows) {
      nlohmann::ordered_json object = nlohmann::ordered_json::object();
      for (const Field& field : row)
        std::visit([&](const auto& value) { object[field.column] = value; }, field.value);
      list.push_back(std::move(object));
    }
    all[file] = std::move(list);
  }
  return all.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace odeum::record
