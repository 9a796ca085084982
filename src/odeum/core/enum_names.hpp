// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

namespace odeum {

/// The text that belongs to an enumerator, from the texts of all up to `last` in their order; empty
/// for a value beyond it.
template <auto last, std::size_t count>
const char* text_of_enumerator(decltype(last) value, const char* const (&texts)[count]) {
  static_assert(count == static_cast<std::size_t>(last) + 1, "every enumerator has a text");
  const auto index = static_cast<std::size_t>(value);
  return index < count ? texts[index] : "";
}

}  // namespace odeum
