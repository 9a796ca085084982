// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace odeum::record {

std::string format_number(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  return error == std::errc{} ? std::string(buffer, end) : "nan";
}

std::string format_text(std::string_view text) {
  std::string field;
  bool quote = false;
  if (!text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos)
    field += '\'';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto code = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    const bool c1 = code(i) == 0xc2 && i + 1 < text.size() && (code(i + 1) & 0xe0) == 0x80;
    if (c1) ++i;  // U+0080 to U+009F are two bytes; U+009B begins an escape as ESC [ does
    if (text[i] == '"') field += '"';
    if (text[i] == '"' || text[i] == ',') quote = true;
    field += c1 || code(i) < 0x20 || code(i) == 0x7f ? ' ' : text[i];
  }
  return quote ? '"' + field + '"' : field;
}

CsvRow& CsvRow::add(Cell cell) {
  text_ += ',';
  text_ += csv_field(cell);
  cells_.push_back(std::move(cell));
  return *this;
}

CsvTable::CsvTable(std::string_view columns, bool keeps_rows)
    : text_("schema,"), keeps_rows_(keeps_rows) {
  text_.append(columns) += '\n';
  while (!columns.empty()) {
    const std::size_t end = std::min(columns.find(','), columns.size());
    columns_.emplace_back(columns.substr(0, end));
    columns.remove_prefix(std::min(end + 1, columns.size()));
  }
}

void CsvTable::add(const CsvRow& row) {
  text_ += row.line();
  text_ += '\n';
  if (!keeps_rows_) return;
  Fields& fields = rows_.emplace_back();
  for (std::size_t i = 0; i < columns_.size(); ++i) fields.push_back({columns_[i], row.cells()[i]});
}

}  // namespace odeum::record
