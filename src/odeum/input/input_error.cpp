// SPDX-License-Identifier: BSD-3-Clause
// Apart from the reader of YAML, for modules that need no more.
#include <fmt/format.h>

#include <algorithm>

#include "odeum/input/utf8.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum {

InputError::InputError(const std::string& file, Place place, const std::string& rest)
    : std::invalid_argument(fmt::format("{}:{}:{}: {}", file, place.line, place.column, rest)) {}

std::string shown(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string line;
  while (!text.empty()) {
    const auto [code, bytes] = first_character(text);
    const std::size_t length = std::max<std::size_t>(bytes, 1);
    if (line.size() + length > longest) return line + "...";
    line += bytes > 0 && is_control(code) ? " " : text.substr(0, length);
    text.remove_prefix(length);
  }
  return line;
}

}  // namespace odeum
