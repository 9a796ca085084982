// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <concepts>
#include <string>
#include <string_view>

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
  CsvRow& text(std::string_view value) { return raw(format_text(value)); }
  CsvRow& number(double value) { return raw(format_number(value)); }
  CsvRow& count(std::integral auto value) { return raw(std::to_string(value)); }
  /// The line, without its end.
  const std::string& line() const { return text_; }

 private:
  CsvRow& raw(const std::string& field) {
    text_ += ',';
    text_ += field;
    return *this;
  }
  std::string text_;
};

/// A whole file: a header line (`schema` and the columns) and rows.
class CsvTable {
 public:
  /// `columns` without `schema`, separated by commas.
  explicit CsvTable(std::string_view columns) : text_("schema,") { text_.append(columns) += '\n'; }
  void add(const CsvRow& row) {
    text_ += row.line();
    text_ += '\n';
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

}  // namespace odeum::record
