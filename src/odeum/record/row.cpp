// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/row.hpp"

#include <charconv>

#include "odeum/record/csv.hpp"

namespace odeum::record {
namespace {

template <class T>
T parsed(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) throw BadField();
  return value;
}

}  // namespace

std::string cell_text(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* number = std::get_if<double>(&cell)) return format_number(*number);
  if (const auto* count = std::get_if<std::int64_t>(&cell)) return std::to_string(*count);
  return std::to_string(std::get<std::uint64_t>(cell));
}

double number_of(std::string_view text) { return parsed<double>(text); }
std::int64_t integer_of(std::string_view text) { return parsed<std::int64_t>(text); }

}  // namespace odeum::record
