// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/csv.hpp"

#include <charconv>
#include <cmath>

#include "odeum/input/utf8.hpp"

namespace odeum::record {
namespace {

// Also after apostrophes of the text's own, so that a reader knows whose the first one is.
bool begins_a_formula(std::string_view text) {
  const std::size_t begin = text.find_first_not_of('\'');
  return begin != std::string_view::npos &&
         std::string_view("=+-@").find(text[begin]) != std::string_view::npos;
}

std::string csv_field(const Cell& cell) {
  const auto* text = std::get_if<std::string>(&cell);
  return text ? format_text(*text) : cell_text(cell);
}

}  // namespace

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
  if (begins_a_formula(text)) field += '\'';
  while (!text.empty()) {
    const auto [code, bytes] = first_character(text);
    const std::string_view character = text.substr(0, bytes == 0 ? 1 : bytes);
    if (code == '"') field += '"';
    if (code == '"' || code == ',') quote = true;
    field += bytes > 0 && is_control(code) ? " " : character;
    text.remove_prefix(character.size());
  }
  return quote ? '"' + field + '"' : field;
}

std::string text_of_field(std::string field) {
  return field.starts_with('\'') && begins_a_formula(field) ? field.substr(1) : field;
}

std::string csv_header(const Fields& blank) {
  std::string line = "schema";
  for (const Field& field : blank) line += ',' + format_text(field.column);
  return line + '\n';
}

std::string csv_line(int schema, const Fields& row) {
  std::string line = std::to_string(schema);
  for (const Field& field : row) line += ',' + csv_field(field.value);
  return line + '\n';
}

std::vector<Fields> Records::fields() const {
  std::vector<Fields> all;
  for (const std::vector<Cell>& row : rows) {
    Fields& fields = all.emplace_back();
    for (std::size_t i = 0; i < columns.size(); ++i) fields.push_back({columns[i], row[i]});
  }
  return all;
}

std::string Records::csv() const {
  std::string text = "schema";
  for (const std::string& column : columns) text += ',' + format_text(column);
  for (const std::vector<Cell>& row : rows) {
    text += '\n' + std::to_string(csv_schema);
    for (const Cell& cell : row) text += ',' + csv_field(cell);
  }
  return text + '\n';
}

}  // namespace odeum::record
