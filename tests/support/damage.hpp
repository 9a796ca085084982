// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <random>
#include <span>
#include <string>
#include <string_view>

namespace odeum::tests {

/// A text with one to three faults: a piece inserted, some of it removed, doubled or cut off, or a
/// byte changed to any other. The same ones from the same state of the generator.
inline std::string damaged(std::string text, std::span<const std::string_view> pieces,
                           std::mt19937& random) {
  const auto below = [&](std::size_t n) { return n ? random() % n : 0; };
  const std::size_t faults = 1 + below(3);
  for (std::size_t k = 0; k < faults; ++k) {
    const std::size_t at = below(text.size() + 1), length = below(12);
    switch (below(6)) {
      case 0:
      case 1:
        text.insert(at, pieces[below(pieces.size())]);
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      case 4:
        text.insert(at, text.substr(below(text.size() + 1), length));
        break;
      default:
        if (below(4) == 0) text.resize(at);
        break;
    }
  }
  return text;
}

}  // namespace odeum::tests
