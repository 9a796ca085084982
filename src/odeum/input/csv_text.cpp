// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/input/csv_text.hpp"

#include <algorithm>
#include <charconv>
#include <limits>
#include <string>

namespace odeum::input {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

char separator_of(std::string_view line) {
  for (const char separator : {'\t', ';', ','})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ' ';
}

std::vector<Cell> cells_of(std::string_view line, char separator) {
  std::vector<Cell> cells;
  std::size_t begin = 0;
  bool quoted = false;
  const auto add = [&](std::size_t end) {
    std::string_view cell = line.substr(begin, end - begin);
    std::size_t column = begin + 1;
    for (; !cell.empty() && is_blank(cell.front()); ++column) cell.remove_prefix(1);
    cell = trimmed(cell);
    if (cell.size() > 1 && cell.front() == '"' && cell.back() == '"')
      cell = cell.substr(1, cell.size() - 2);
    if (separator != ' ' || !cell.empty()) cells.push_back({cell, column});
  };
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '"') quoted = !quoted;
    if (quoted || (separator == ' ' ? !is_blank(line[i]) : line[i] != separator)) continue;
    add(i);
    begin = i + 1;
  }
  add(line.size());
  return cells;
}

std::optional<double> number_in(std::string_view cell, bool decimal_comma) {
  std::string text(cell);
  if (decimal_comma) std::ranges::replace(text, ',', '.');
  const char* begin = text.data();
  const char* const end = begin + text.size();
  if (begin != end && *begin == '+') ++begin;
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  if (rest != end || error == std::errc::invalid_argument) return {};
  if (error == std::errc::result_out_of_range) {
    if (text.find("e-") != std::string::npos || text.find("E-") != std::string::npos) return 0;
    return (*begin == '-' ? -1 : 1) * std::numeric_limits<double>::infinity();
  }
  return value;
}

Lines::Lines(std::string_view text) : rest_(text) {
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  if (rest_.starts_with(mark)) rest_.remove_prefix(mark.size());
}

bool Lines::next() {
  while (!rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++number_;
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    if (!trimmed(line_).empty()) return true;
  }
  return false;
}

}  // namespace odeum::input
