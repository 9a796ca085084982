// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/printed_text.hpp"

namespace odeum::cases {

// lists/printed.inc is generated: the stems of the texts in cases/, of which each is printed.
#define ODEUM_ITEM(stem) PrintedText printed_##stem();
#include "lists/printed.inc"
#undef ODEUM_ITEM

const PrintedText* printed_of(std::string_view stem) {
#define ODEUM_ITEM(name)                              \
  if (stem == #name) {                                \
    static const PrintedText text = printed_##name(); \
    return &text;                                     \
  }
#include "lists/printed.inc"
#undef ODEUM_ITEM
  return nullptr;
}

}  // namespace odeum::cases
