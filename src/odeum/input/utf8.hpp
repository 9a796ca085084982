// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace odeum {

/// A character at the head of a text: its code point and bytes; 0 bytes where it is not UTF-8.
struct Utf8Character {
  std::uint32_t code = 0;
  std::size_t bytes = 0;
};
Utf8Character first_character(std::string_view text);

/// Line breaks, terminal escapes, and those of Latin-1, of which U+009B begins an escape too.
inline bool is_control(std::uint32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

/// Characters that turn the direction of writing, so that a text reads as another one.
bool turns_direction(std::uint32_t code);

/// A text as a terminal may have it: every line break but \n, every other control character but the
/// tab, what turns the direction of writing and what cannot be seen is escaped as in JSON (\u001b),
/// so that a JSON text stays the same data. Bytes that are not UTF-8 become U+FFFD.
std::string for_terminal(std::string_view text);

}  // namespace odeum
