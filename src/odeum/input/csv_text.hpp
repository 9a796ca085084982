// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

/// Tables of cells as people, spreadsheets and other programs write them.
namespace odeum::input {

/// A cell without blanks and quotes around it.
struct Cell {
  std::string_view text;
  std::size_t column = 1;  ///< where it begins in its line, from 1
};

/// What separates the cells of a line: a tab or a semicolon where there is one, since a comma
/// beside these is that of decimals; else a comma; else a blank, which stands for any blanks.
char separator_of(std::string_view line);
/// The cells of a line between separators outside of quotes.
std::vector<Cell> cells_of(std::string_view line, char separator);
/// The number that a cell says, also an infinite one; nothing for another text. One too large or
/// too small for a double is infinite or 0.
std::optional<double> number_in(std::string_view cell, bool decimal_comma = false);

/// Goes through the lines of a text that are not blank; a mark of byte order before them and CR
/// at their ends are left out.
///
///     for (Lines lines(text); lines.next();) read(lines.number(), lines.line());
class Lines {
 public:
  explicit Lines(std::string_view text);
  bool next();
  std::size_t number() const { return number_; }  ///< in the text, from 1
  std::string_view line() const { return line_; }

 private:
  std::string_view rest_, line_;
  std::size_t number_ = 0;
};

/// Without blanks around it.
std::string_view trimmed(std::string_view text);

}  // namespace odeum::input
