// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/printed_text.hpp"

#include <utility>

namespace odeum::cases {

// lists/printed.inc is generated: the stems of the texts in cases/, of which each is printed.
#define ODEUM_ITEM(stem) PrintedText printed_##stem();
#include "lists/printed.inc"
#undef ODEUM_ITEM

namespace {

const std::vector<std::pair<std::string_view, PrintedText>>& all_printed() {
  static const std::vector<std::pair<std::string_view, PrintedText>> all{
#define ODEUM_ITEM(stem) {#stem, printed_##stem()},
#include "lists/printed.inc"
#undef ODEUM_ITEM
  };
  return all;
}

}  // namespace

const PrintedText* printed_of(std::string_view stem) {
  for (const auto& [name, text] : all_printed())
    if (name == stem) return &text;
  return nullptr;
}

const PrintedText* printed_with(std::string_view code) {
  for (const auto& [name, text] : all_printed())
    if (text.code == code) return &text;
  return nullptr;
}

}  // namespace odeum::cases
