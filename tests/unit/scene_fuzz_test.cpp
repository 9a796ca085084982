// SPDX-License-Identifier: BSD-3-Clause
// Damaged scenes, the same ones each time: see tests/fuzz/scene_reader_fuzz.cpp for the long run.
#include <gtest/gtest.h>

#include <random>

#include "fuzz/read_any.hpp"
#include "support/scene_stage.hpp"

namespace odeum {
namespace {

std::string damaged(std::string text, std::mt19937& random) {
  static const std::string pieces[] = {
      "{",    "}", "[",     "]", ": ",   "- ",   "\n",    "\t", "&a ",         "*a",
      "!!x ", "#", "\"",    "'", "|\n",  "? ",   "1e999", "-1", ".nan",        "010",
      "\xff", ",", "---\n", "%", "<<: ", "null", "true",  "~",  "\xe2\x80\xa8"};
  const auto below = [&](std::size_t n) { return n ? random() % n : 0; };
  const std::size_t damages = 1 + below(3);
  for (std::size_t k = 0; k < damages; ++k) {
    const std::size_t at = below(text.size() + 1), length = below(12);
    switch (below(5)) {
      case 0:
        text.insert(at, pieces[below(std::size(pieces))]);
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      case 3:
        text.insert(at, text.substr(below(text.size() + 1), length));
        break;
      default:
        if (below(4) == 0) text.resize(at);  // truncated
        break;
    }
  }
  return text;
}

TEST(SceneFuzz, DamagedScenesAreReadOrRefused) {
  std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same run each time
  std::size_t count = 0;
  for (const cases::SceneText& scene : cases::all_scenes()) {
    // The long lists of some scenes are uniform: a part of them suffices.
    const std::string text(scene.text.substr(0, 1500));
    for (int k = 0; k < 250; ++k, ++count) {
      const std::string mutant = damaged(text, random);
      ASSERT_TRUE(fuzz::read_any(mutant)) << mutant;
    }
  }
  EXPECT_GE(count, 3000U);
}

}  // namespace
}  // namespace odeum
