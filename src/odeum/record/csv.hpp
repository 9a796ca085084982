// SPDX-License-Identifier: BSD-3-Clause
#pragma once
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
/// The text of such a field, without its quotes: the apostrophe is taken off.
std::string text_of_field(std::string field);

/// Rows whose columns are known at run time alone.
struct Records {
  std::vector<std::string> columns = {};
  std::vector<std::vector<Cell>> rows = {};  ///< as many cells each as there are columns
  std::vector<Fields> fields() const;
  /// The text of a file: a header, then a line a row.
  std::string csv() const;
};

/// The lines of a file, with their ends.
std::string csv_header(const Fields& blank);
std::string csv_line(int schema, const Fields& row);

}  // namespace odeum::record
