// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace odeum::record {

/// Reads back what CsvTable wrote: a header, then rows of as many fields. Points into the text.
class CsvReader {
 public:
  explicit CsvReader(std::string_view text);
  /// The next row; false at the end, or at a row of another length, see broken().
  bool next();
  bool broken() const { return broken_; }
  bool has(const std::string& column) const { return columns_.contains(column); }
  /// A field of the row. Throws std::out_of_range for an unknown column.
  const std::string& text(const std::string& column) const { return row_[columns_.at(column)]; }
  /// Nothing where the field is not a number.
  std::optional<double> number(const std::string& column) const;

 private:
  bool read_row();

  std::string_view rest_;
  std::map<std::string, std::size_t> columns_;
  std::vector<std::string> row_;
  bool broken_ = false;
};

}  // namespace odeum::record
