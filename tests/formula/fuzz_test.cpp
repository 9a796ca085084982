// SPDX-License-Identifier: BSD-3-Clause
// Damaged problem files, the same ones each time: see tests/fuzz/problem_reader_fuzz.cpp for the
// long run.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "fuzz/read_any_problem.hpp"
#include "support/temporary_folder.hpp"

namespace odeum {
namespace {

std::string damaged(std::string text, std::mt19937& random) {
  static const std::string pieces[] = {
      "{",   "}",  "[",    "]",     ": ", "\n", "t",   "u[0]", "^",    "^9^9", "1e999",
      "-1",  "/0", "if(",  "sqrt(", "(",  ")",  ",",   "*",    "\xff", "&a ",  "*a",
      "nan", "..", "1e-9", "pi",    "i",  "<",  "===", "\"",   "'",    "#"};
  const auto below = [&](std::size_t n) { return n ? random() % n : 0; };
  const std::size_t damages = 1 + below(3);
  for (std::size_t k = 0; k < damages; ++k) {
    const std::size_t at = below(text.size() + 1), length = below(12);
    switch (below(5)) {
      case 0:
      case 1:
        text.insert(at, pieces[below(std::size(pieces))]);
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      default:
        text.insert(at, text.substr(below(text.size() + 1), length));
        break;
    }
  }
  return text;
}

TEST(ProblemFuzz, DamagedProblemsAreReadOrRefused) {
  std::mt19937 random(11);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same run each time
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(ODEUM_SOURCE_DIR "/cases/problems")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string text = tests::text_of(entry.path());
    for (int k = 0; k < 400; ++k, ++count) {
      const std::string mutant = damaged(text, random);
      ASSERT_TRUE(fuzz::read_any_problem(mutant)) << mutant;
    }
  }
  EXPECT_GE(count, 3600);
}

}  // namespace
}  // namespace odeum
