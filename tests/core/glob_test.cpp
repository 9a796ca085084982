// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/glob.hpp"

#include <gtest/gtest.h>

namespace odeum::tests::glob_test {
namespace {

/// The definition, by recursion.
bool matches(std::string_view pattern, std::string_view text) {
  if (pattern.empty()) return text.empty();
  if (pattern[0] == '*')
    return matches(pattern.substr(1), text) || (!text.empty() && matches(pattern, text.substr(1)));
  return !text.empty() && (pattern[0] == '?' || pattern[0] == text[0]) &&
         matches(pattern.substr(1), text.substr(1));
}

/// Every text of up to `length` of these characters.
std::vector<std::string> all_texts(std::string_view characters, std::size_t length) {
  std::vector<std::string> texts{""};
  for (std::size_t begin = 0, size = 1; size <= length; ++size) {
    const std::size_t end = texts.size();
    for (; begin < end; ++begin)
      for (const char c : characters) texts.push_back(texts[begin] + c);
  }
  return texts;
}

TEST(Glob, AgreesWithItsDefinitionOnAllShortPatterns) {
  for (const std::string& pattern : all_texts("ab*?", 5))
    for (const std::string& text : all_texts("ab", 5))
      ASSERT_EQ(glob_matches(pattern, text), matches(pattern, text)) << pattern << " on " << text;
}

TEST(Glob, TakesNoTimeOnManyStars) {
  // The recursion above would take longer than the universe has.
  std::string pattern;
  for (int i = 0; i < 60; ++i) pattern += "a*";
  EXPECT_FALSE(glob_matches(pattern + "b", std::string(5000, 'a')));
}

TEST(Glob, NoPatternMatchesEverything) {
  EXPECT_TRUE(any_glob_matches({}, "odeum/rk4"));
  EXPECT_TRUE(any_glob_matches({"gsl/*", "odeum/rk?"}, "odeum/rk4"));
  EXPECT_FALSE(any_glob_matches({"gsl/*", ""}, "odeum/rk4"));
}

}  // namespace
}  // namespace odeum::tests::glob_test
