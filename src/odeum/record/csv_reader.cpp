// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/csv_reader.hpp"

#include <charconv>

namespace odeum::record {

CsvReader::CsvReader(std::string_view text) : rest_(text) {
  if (!read_row()) return;
  for (std::size_t i = 0; i < row_.size(); ++i) columns_[row_[i]] = i;
}

bool CsvReader::next() {
  if (broken_ || !read_row()) return false;
  broken_ = row_.size() != columns_.size();
  return !broken_;
}

// One line: a field may be quoted, and then holds commas and doubled quotes; CsvTable writes no
// line breaks within one. A last line without an end was cut off.
bool CsvReader::read_row() {
  if (rest_.empty()) return false;
  row_.assign(1, "");
  bool quoted = false;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const char c = rest_[i];
    if (c == '\n') {
      rest_.remove_prefix(i + 1);
      return true;
    }
    if (c == '"' && quoted && i + 1 < rest_.size() && rest_[i + 1] == '"')
      row_.back() += rest_[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      row_.emplace_back();
    else
      row_.back() += c;
  }
  broken_ = true;
  return false;
}

std::optional<double> CsvReader::number(const std::string& column) const {
  const std::string& field = text(column);
  double value = 0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  if (error != std::errc() || end != field.data() + field.size()) return std::nullopt;
  return value;
}

}  // namespace odeum::record
