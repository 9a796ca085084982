// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/input/near_words.hpp"

#include <gtest/gtest.h>

namespace odeum::tests::near_words_test {
namespace {

TEST(Nearest, FindsWhatWasMeant) {
  const std::vector<std::string> ids{"odeum/rk4", "odeum/heun", "odeum/midpoint", "free_fall"};
  EXPECT_EQ(nearest("odeum/rk5", ids), "odeum/rk4");
  EXPECT_EQ(nearest("odeum/midpiont", ids), "odeum/midpoint");
  EXPECT_EQ(nearest("freefall", ids), "free_fall");
  EXPECT_EQ(nearest("heun", {"heun", "huen"}), "heun");
}

TEST(Nearest, KnowsWhatOtherProgramsCallAKey) {
  const std::vector<std::string> keys{"states", "equations", "time"};
  EXPECT_EQ(nearest("y0", keys), "states");
  EXPECT_EQ(nearest("start", keys), "states");
  EXPECT_EQ(nearest("odes", keys), "equations");
  EXPECT_EQ(nearest("tspan", keys), "time");
  EXPECT_EQ(nearest("tspan", {"mass"}), "");
}

TEST(Nearest, SaysNothingWhereNothingIsNear) {
  EXPECT_EQ(nearest("lorenz", {"odeum/rk4", "free_fall"}), "");
  EXPECT_EQ(nearest("abc", {"xyz"}), "");
  EXPECT_EQ(nearest("anything", {}), "");
  // At most one more than a third of the word: three letters of six, not four.
  EXPECT_EQ(nearest("abcdef", {"abcxyz"}), "abcxyz");
  EXPECT_EQ(nearest("abcdef", {"abwxyz"}), "");
}

TEST(Nearest, OffersAllCandidatesAndTheNearest) {
  EXPECT_EQ(one_of({"mass", "radius"}), "one of mass, radius");
  EXPECT_EQ(one_of({"mass", "radius"}, "mas"), "one of mass, radius; did you mean mass?");
  EXPECT_EQ(one_of({"mass"}, "stiffness"), "mass");
  EXPECT_EQ(one_of({"m"}, ""), "m");
}

}  // namespace
}  // namespace odeum::tests::near_words_test
