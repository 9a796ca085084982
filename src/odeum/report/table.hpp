// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "odeum/record/table.hpp"

namespace odeum::report {

/// One cell of a table.
struct Cell {
  std::string text = {};    ///< escaped when printed
  std::string style = {};   ///< names of classes
  std::string title = {};   ///< shown when pointed at; escaped when printed
  std::string markup = {};  ///< printed as it is, in place of `text`; escaped by whoever made it
  std::size_t columns = 1, rows = 1;  ///< spanned
};

/// A table of a page: header rows, then body rows that begin with a header cell.
class Table {
 public:
  /// `style` holds names of classes of the style sheet.
  explicit Table(std::string style) : style_(std::move(style)) {}

  void head(const std::vector<Cell>& cells);
  void row(const Cell& name, const std::vector<Cell>& cells, std::string_view style = {});

  std::size_t rows() const { return rows_; }
  /// The <table> in a box that scrolls where it is too wide; nothing where there is no row.
  std::string html() const;

 private:
  std::string style_, head_, body_;
  std::size_t rows_ = 0;
};

/// Rows that are text alone; the first column names the row.
std::string html_of(const record::Table& table, std::string style = "numbers");

/// A <details> element; `summary` and `body` are markup. Nothing where `body` is empty.
std::string details(std::string_view summary, std::string_view body, bool open = false);

}  // namespace odeum::report
