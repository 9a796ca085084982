// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <concepts>
#include <string>
#include <string_view>
#include <vector>

#include "odeum/record/row.hpp"

namespace odeum::record {

/// The first column of every file: the version of its columns.
inline constexpr int csv_schema = 1;

/// A number as the shortest text that reads back to the same double; `nan`, `inf`, `-inf`.
/// Independent of the locale.
std::string format_number(double value);

/// A text field: quoted where it must be (comma, quote, line break), control characters (line
/// breaks, terminal escapes, those of Latin-1 in UTF-8 too) replaced by spaces, and an apostrophe
/// before a leading = + - @, which spreadsheets would run as a formula.
std::string format_text(std::string_view text);

/// One row of a CSV file, built field by field.
class CsvRow {
 public:
  CsvRow() : text_(std::to_string(csv_schema)) {}
  CsvRow& text(std::string_view value) { return add(std::string(value)); }
  CsvRow& number(double value) { return add(value); }
  CsvRow& count(std::signed_integral auto value) { return add(static_cast<std::int64_t>(value)); }
  CsvRow& count(std::unsigned_integral auto value) {
    return add(static_cast<std::uint64_t>(value));
  }
  /// The line, without its end.
  const std::string& line() const { return text_; }
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  CsvRow& add(Cell cell);
  std::string text_;
  std::vector<Cell> cells_;
};

/// A whole file whose columns are known at run time alone: a header line (`schema` and the columns)
/// and rows.
class CsvTable {
 public:
  /// `columns` without `schema`, separated by commas. `keeps_rows`: for rows().
  explicit CsvTable(std::string_view columns, bool keeps_rows = false);
  void add(const CsvRow& row);
  const std::string& text() const { return text_; }
  const std::vector<std::string>& columns() const { return columns_; }
  const std::vector<Fields>& rows() const { return rows_; }

 private:
  std::string text_;
  std::vector<std::string> columns_;
  bool keeps_rows_;
  std::vector<Fields> rows_;
};

}  // namespace odeum::record
