// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace odeum::study::packing_test {
namespace {

PlannedTasks tasks_of(const std::vector<double>& seconds, std::size_t first_alone) {
  PlannedTasks tasks;
  tasks.seconds = seconds;
  for (std::size_t k = 0; k < seconds.size(); ++k) tasks.alone.push_back(k >= first_alone);
  return tasks;
}

TEST(Packing, TheLongestFirstEachToTheShardThatHasTheLeast) {
  const Packing packing = pack(tasks_of({1, 7, 2, 5, 3}, 5), 2);
  // 7 | 5, then 3 to the second, 2 to the first, 1 to the second or first: both have 9 or 8 before.
  ASSERT_EQ(packing.seconds.size(), 2U);
  EXPECT_EQ(packing.seconds[0], 9);
  EXPECT_EQ(packing.seconds[1], 9);
  EXPECT_EQ(packing.shares[1], packing.shares[2]);
  EXPECT_EQ(packing.shares[3], packing.shares[4]);
  EXPECT_EQ(packing.first_alone, 2U);
  EXPECT_EQ(shares_of(text_of_shares(packing.shares)), packing.shares);
}

TEST(Packing, NoShardIsEmptyAndTheLongestShardIsFirst) {
  const Packing packing = pack(tasks_of({0, 0, 9, 0}, 4), 9);
  EXPECT_EQ(packing.seconds, (std::vector<double>{9, 0, 0, 0}));
  EXPECT_EQ(packing.shares[2], 0U);
}

TEST(Packing, TimedTasksHaveShardsOfTheirOwnBehindTheOthers) {
  const Packing packing = pack(tasks_of({1, 1, 1, 1, 6, 6}, 4), 4);
  EXPECT_EQ(packing.first_alone, 1U);  // a quarter of the work
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(packing.shares[k], 0U);
  EXPECT_NE(packing.shares[4], packing.shares[5]);
  EXPECT_EQ(pack(tasks_of({1, 1}, 0), 1).first_alone, 0U);
}

TEST(Packing, OneShardHasTimedTasksAndTheOthers) {
  const Packing packing = pack(tasks_of({1, 2, 6}, 2), 1);
  EXPECT_EQ(packing.seconds, std::vector<double>{9});
  EXPECT_EQ(packing.first_alone, 0U);
}

// Earlier runs are believed, a sample is timed, and the rest is as long as the nearest of these.
TEST(PlannedTasks, TakeWhatIsKnownOrNearest) {
  PlannedTasks tasks;
  std::size_t worked = 0;
  const auto earlier = [](std::size_t k) { return k == 2 ? 5. : k == 9 ? 7. : std::nan(""); };
  tasks.add(10, earlier, [&](std::size_t) { ++worked; });
  EXPECT_EQ(worked, 1U);
  EXPECT_EQ(tasks.timed, 1U);
  EXPECT_EQ(tasks.earlier, 2U);
  ASSERT_EQ(tasks.seconds.size(), 10U);
  EXPECT_EQ(tasks.seconds[0], 5);
  EXPECT_EQ(tasks.seconds[2], 5);
  EXPECT_EQ(tasks.seconds[8], 7);
  // Tasks of a study of times are not done for a plan.
  tasks.add(2, [](std::size_t) { return std::nan(""); }, {});
  EXPECT_EQ(tasks.seconds.size(), 12U);
  EXPECT_TRUE(tasks.alone[11]);
  EXPECT_FALSE(tasks.alone[9]);
}

}  // namespace
}  // namespace odeum::study::packing_test
