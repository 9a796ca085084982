// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/foreign/names.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace odeum::foreign {
namespace {

bool is_name(const std::string& name) {
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

}  // namespace

std::string fault_of_name(const char* what, const char* name) {
  if (!name) return fmt::format("a {} has a null pointer for its name", what);
  if (!is_name(name))
    return fmt::format("{} name: got \"{}\", expected 1 to 64 characters of a-z, 0-9 and _", what,
                       cleaned(name));
  return {};
}

std::string cleaned(const char* text) {
  std::string clean;
  for (; *text && clean.size() < 300; ++text)
    clean += static_cast<unsigned char>(*text) < 32 || *text == 127 ? ' ' : *text;
  return clean;
}

}  // namespace odeum::foreign
