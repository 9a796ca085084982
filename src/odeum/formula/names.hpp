// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include "odeum/formula/operations.hpp"

namespace odeum::formula {

/// The functions of expressions, by name; ceil and mod are made of floor.
const std::map<std::string, Op, std::less<>>& functions();

inline bool begins_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool continues_name(char c) { return begins_name(c) || is_digit(c); }

/// How a function of other languages is written here; empty: it is not known.
std::string_view known_as(std::string_view name);

/// A name that a file may give: letters, digits and _, not the name of a function, of a constant or
/// of t. Returns what is wrong with it; empty: nothing.
std::string fault_of_name(std::string_view name);
/// Whether it joins conditions.
bool is_word_of_conditions(std::string_view name);

}  // namespace odeum::formula
