// SPDX-License-Identifier: BSD-3-Clause
// Damaged scenes, the same ones each time: see tests/fuzz/scene_reader_fuzz.cpp for the long run.
#include <gtest/gtest.h>

#include <random>

#include "fuzz/read_any.hpp"
#include "odeum/cases/scene_case.hpp"
#include "support/damage.hpp"

namespace odeum::scene_fuzz_test {
namespace {

constexpr std::string_view pieces[] = {
    "{",    "}", "[",     "]", ": ",   "- ",   "\n",    "\t", "&a ",         "*a",
    "!!x ", "#", "\"",    "'", "|\n",  "? ",   "1e999", "-1", ".nan",        "010",
    "\xff", ",", "---\n", "%", "<<: ", "null", "true",  "~",  "\xe2\x80\xa8"};

TEST(SceneFuzz, DamagedScenesAreReadOrRefused) {
  std::mt19937 random(7);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same run each time
  std::size_t count = 0;
  for (const cases::SceneText& scene : cases::all_scenes()) {
    // The long lists of some scenes are uniform: a part of them suffices.
    const std::string text(scene.text.substr(0, 1500));
    for (int k = 0; k < 250; ++k, ++count) {
      const std::string mutant = tests::damaged(text, pieces, random);
      ASSERT_TRUE(fuzz::read_any(mutant)) << mutant;
    }
  }
  EXPECT_GE(count, 3000U);
}

}  // namespace
}  // namespace odeum::scene_fuzz_test
