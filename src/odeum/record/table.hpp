// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "odeum/record/rows.hpp"

namespace odeum::record {

/// A table for people: text in cells, ready to be printed.
struct Table {
  struct Column {
    std::string heading;
    bool right = false;  ///< numbers are aligned to the right
  };
  std::vector<Column> columns;
  std::vector<std::vector<std::string>> rows;  ///< as many cells each as there are columns

  /// Lines of columns as wide as their cells.
  std::string text() const;
};

namespace detail {
Table make_table(std::string_view columns, const std::vector<Fields>& rows);
std::string json_text(const std::vector<std::pair<std::string, std::vector<Fields>>>& lists);
}  // namespace detail

/// The named columns of rows. `columns`: names of the file's columns, separated by spaces; a number
/// may have a format of fmt behind a colon, as in "case solver error:.1e status", and is written as
/// .4g without. The library stands before the solver, a detail behind its status, a reason behind
/// its verdict, and both parts of a complex number are one column. Throws std::out_of_range for an
/// unknown name.
template <class Row>
Table table_of(const std::vector<Row>& rows, std::string_view columns) {
  std::vector<Fields> fields{fields_of(Row())};
  for (const Row& row : rows) fields.push_back(fields_of(row));
  return detail::make_table(columns, fields);
}

/// The tables of a result for a terminal: of each list that has rows, and a Row that says with
/// `shown` which columns. Where there are several, each has the name of its file above it.
template <class Result>
std::string tables_of(const Result& result) {
  std::vector<std::pair<std::string, std::string>> tables;
  for_each_list(result, [&]<class Row>(const std::vector<Row>& rows) {
    if constexpr (requires { Row::shown; })
      if (!rows.empty()) tables.emplace_back(Row::file, table_of(rows, Row::shown).text());
  });
  if (tables.size() == 1) return tables.front().second;
  std::string text;
  for (const auto& [file, table] : tables) {
    if (!text.empty()) text += '\n';
    text.append(file).append("\n\n").append(table);
  }
  return text;
}

/// The lists of a result as JSON: by the name of their file an array of objects, one a row. Numbers
/// are numbers, and null where they are not finite. Files that are large, and compressed for that,
/// are left out.
template <class Result>
std::string json_of(const Result& result) {
  std::vector<std::pair<std::string, std::vector<Fields>>> lists;
  for_each_list(result, [&]<class Row>(const std::vector<Row>& rows) {
    if (!is_compressed<Row>()) lists.emplace_back(Row::file, fields_of(rows));
  });
  return detail::json_text(lists);
}

}  // namespace odeum::record
