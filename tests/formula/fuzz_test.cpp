// SPDX-License-Identifier: BSD-3-Clause
// Damaged problem files, the same ones each time: see tests/fuzz/problem_reader_fuzz.cpp for the
// long run.
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "fuzz/read_any_problem.hpp"
#include "support/damage.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::fuzz_test {
namespace {

constexpr std::string_view pieces[] = {
    "{",   "}",  "[",    "]",     ": ", "\n", "t",   "u[0]", "^",    "^9^9", "1e999",
    "-1",  "/0", "if(",  "sqrt(", "(",  ")",  ",",   "*",    "\xff", "&a ",  "*a",
    "nan", "..", "1e-9", "pi",    "i",  "<",  "===", "\"",   "'",    "#"};

TEST(ProblemFuzz, DamagedProblemsAreReadOrRefused) {
  std::mt19937 random(11);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same run each time
  int count = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(ODEUM_SOURCE_DIR "/cases/problems")) {
    if (entry.path().extension() != ".yaml") continue;
    const std::string text = tests::text_of(entry.path());
    for (int k = 0; k < 400; ++k, ++count) {
      const std::string mutant = tests::damaged(text, pieces, random);
      ASSERT_TRUE(fuzz::read_any_problem(mutant)) << mutant;
    }
  }
  EXPECT_GE(count, 3600);
}

}  // namespace
}  // namespace odeum::fuzz_test
