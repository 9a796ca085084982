// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <charconv>
#include <string>

namespace odeum {

/// The shortest text that reads back to the same number, for messages of headers that must not
/// need a library for it.
inline std::string text_of(double number) {
  char text[32];
  return std::string(text, std::to_chars(text, text + sizeof text, number).ptr);
}

}  // namespace odeum
