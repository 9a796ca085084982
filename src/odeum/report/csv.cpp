// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/csv.hpp"

#include <charconv>
#include <cmath>

namespace odeum::report {

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
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (c == '"') field += '"';
    if (c == '"' || c == ',') quote = true;
    field += code < 0x20 || code == 0x7f ? ' ' : c;
  }
  return quote ? '"' + field + '"' : field;
}

}  // namespace odeum::report
