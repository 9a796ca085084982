// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/text.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>

#include "odeum/input/utf8.hpp"

namespace odeum::report {
namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD";  // U+FFFD

}  // namespace

std::string plain(std::string_view text) {
  std::string safe;
  safe.reserve(text.size());
  while (!text.empty()) {
    const Utf8Character c = first_character(text);
    if (c.code == '\n' || c.code == '\r' || c.code == '\t' || c.code == 0x2028 || c.code == 0x2029)
      safe += ' ';
    else if (c.bytes == 0 || is_control(c.code) || turns_direction(c.code))
      safe += replacement;
    else
      safe += text.substr(0, c.bytes);
    text.remove_prefix(c.bytes == 0 ? 1 : c.bytes);
  }
  return safe;
}

std::string file_stem(std::string_view text) {
  std::string stem;
  for (const char c : text.substr(0, 80))
    stem += std::isalnum(static_cast<unsigned char>(c)) || c == '-' ? c : '_';
  return stem.empty() ? "_" : stem;
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string encoded;
  encoded.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t present = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < present ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      encoded += k <= present ? alphabet[group >> (18 - 6 * k) & 0x3FU] : '=';
  }
  return encoded;
}

}  // namespace odeum::report
