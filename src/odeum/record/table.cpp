// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>

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

// One number and nothing else.
bool is_number(const std::string& format) {
  return format.find('{', 1) == std::string::npos && format.ends_with("}") &&
         format.find(':') != std::string::npos;
}

}  // namespace

std::string Table::text() const {
  std::vector<std::string> headings;
  std::vector<std::size_t> widths;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    headings.push_back(columns[k].heading);
    widths.push_back(headings[k].size());
    for (const auto& row : rows) widths[k] = std::max(widths[k], row[k].size());
  }
  std::string text = line_of(headings, widths, columns);
  for (const auto& row : rows) text += line_of(row, widths, columns);
  return text;
}

Table detail::make_table(const std::vector<TableColumn>& columns, const std::vector<Fields>& rows) {
  Table table;
  for (const TableColumn& column : columns)
    table.columns.push_back({column.heading, is_number(column.cell)});
  for (const auto& fields : rows) {
    fmt::dynamic_format_arg_store<fmt::format_context> values;
    for (const Field& field : fields)
      std::visit(
          [&](const auto& value) { values.push_back(fmt::arg(field.column.c_str(), value)); },
          field.value);
    auto& cells = table.rows.emplace_back();
    for (const TableColumn& column : columns) {
      cells.push_back(fmt::vformat(column.cell, values));
      // Not known, or none; of a complex number both parts.
      if (cells.back() == "nan" || cells.back().starts_with("nan ")) cells.back() = "-";
      if (cells.back().ends_with(": ")) cells.back().resize(cells.back().size() - 2);
    }
  }
  return table;
}

}  // namespace odeum::record
