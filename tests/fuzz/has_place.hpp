// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace odeum::fuzz {

/// Whether an error begins with f:line:column:, and prints no line feed or escape of the input.
inline bool has_place(const std::string& what) {
  std::size_t at = 2;
  for (int part = 0; part < 2; ++part) {
    const std::size_t digits = what.find_first_not_of("0123456789", at);
    if (digits == at || digits == std::string::npos || what[digits] != ':') return false;
    at = digits + 1;
  }
  return what.starts_with("f:") && what.find_first_of("\n\r\x1b") == std::string::npos;
}

}  // namespace odeum::fuzz
