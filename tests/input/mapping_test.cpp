// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/input/mapping.hpp"

#include <gtest/gtest.h>

namespace odeum::tests::mapping_test {
namespace {

/// Reads a text as a mapping of `a` and `b`, of which `a` may be a mapping of `x`; what is wrong.
std::string fault_of(const std::string& text, std::vector<std::string>* warnings = nullptr) {
  static constexpr std::string_view unused[] = {"colour"};
  try {
    const auto root = parse_yaml("f.yaml", text, {.name = "format"});
    input::Reading reading{.file = "f.yaml", .format = "format", .unused = unused};
    const input::Mapping mapping({reading, *root, ""}, {"a", "b"});
    mapping.with("a", [](const input::Value& a) { input::Mapping(a, {"x"}).at("x").number(); });
    if (warnings) *warnings = reading.warnings;
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Mapping, NamesThePlaceAndThePathOfAFault) {
  EXPECT_EQ(fault_of("a: {x: 1}\n"), "");
  EXPECT_EQ(
      fault_of("[1]\n"),
      "f.yaml:1:1: format: not a mapping; got a list of 1, expected keys and values, as {a: ...}");
  EXPECT_EQ(fault_of("a: {x: 1}\nbb: 1\n"),
            "f.yaml:2:1: bb: an unknown key; did you mean b?; got bb, expected one of a, b");
  EXPECT_EQ(fault_of("a: {y: 1}\n"),
            "f.yaml:1:5: a.y: an unknown key; did you mean x?; got y, expected x");
  EXPECT_EQ(fault_of("b: 1\na: {x: 1}\nb: 2\n"),
            "f.yaml:3:1: b: duplicate key; the first is in line 1; got b, expected it once");
  EXPECT_EQ(fault_of("a: {}\n"), "f.yaml:1:4: a.x: missing; got nothing, expected a value");
  EXPECT_EQ(fault_of("a: {x: [1, 2]}\n"),
            "f.yaml:1:8: a.x: not a number; got a list of 2, expected a number");
}

TEST(Mapping, WarnsOfKeysThatAreNotUsed) {
  std::vector<std::string> warnings;
  EXPECT_EQ(fault_of("colour: 1\n", &warnings), "");
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_EQ(warnings[0], "f.yaml:1:1: colour: only a viewer needs it; it is not used");
}

TEST(Mapping, EntriesAreUniqueAndMayBeNone) {
  const auto root = parse_yaml("f.yaml", "{u[1]: {v[2]: 1}, w: ~}\n",
                               {.name = "format", .aliases = false, .indices = true});
  input::Reading reading{.file = "f.yaml", .format = "format"};
  const std::vector<input::Entry> all = input::Value(reading, *root, "").entries();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].key, "u[1]");
  EXPECT_EQ(all[0].value->items[0]->text, "v[2]");
  EXPECT_EQ(input::entry_of(all, "w"), &all[1]);
  EXPECT_EQ(input::entry_of(all, "v"), nullptr);
  EXPECT_TRUE(input::Value(reading, *all[1].value, "w").entries().empty());
}

}  // namespace
}  // namespace odeum::tests::mapping_test
