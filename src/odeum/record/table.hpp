// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/record/row.hpp"

namespace odeum::record {

/// A table for people: text in cells, ready to be printed or made into HTML.
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

/// A column of a table made from rows: `cell` is a format in fmt's syntax in which the columns of
/// the file stand by name, as in "{library}/{solver}" or "{error:.1e}". A trailing ": " of the
/// result is removed.
struct TableColumn {
  std::string heading, cell;
};

namespace detail {
Table make_table(const std::vector<TableColumn>& columns, const std::vector<Fields>& rows);
}

/// Throws fmt::format_error where a format names an unknown column.
template <class Row>
Table table_of(const std::vector<Row>& rows, const std::vector<TableColumn>& columns) {
  return detail::make_table(columns, fields_of(rows));
}

}  // namespace odeum::record
