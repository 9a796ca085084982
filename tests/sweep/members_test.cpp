// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/members.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

namespace odeum::sweep::members_test {
namespace {

TEST(SweepMembers, AGridHasEveryCombinationTheLastAxisFastest) {
  const Members members({axis_of("k=1e2..1e6:log5"), axis_of("d=0..5:6")}, 0, 1);
  ASSERT_EQ(members.size(), 30U);
  EXPECT_EQ(members.names(), (std::vector<std::string>{"k", "d"}));
  for (std::uint64_t member = 0; member < members.size(); ++member) {
    const std::vector<double> values = members.values(member);
    const std::uint64_t decade = 2 + member / 6;
    EXPECT_NEAR(values[0], std::pow(10, static_cast<double>(decade)), 1e-8 * values[0]);
    EXPECT_EQ(values[1], static_cast<double>(member % 6));
  }
  EXPECT_EQ(members.values(29), (std::vector<double>{1e6, 5}));
  EXPECT_EQ(Members({axis_of("k=3,-1.5,2")}, 0, 1).values(1), std::vector<double>{-1.5});
}

TEST(SweepMembers, DrawsFollowFromTheirNumberAndTheSeed) {
  const std::vector<Axis> axes{axis_of("a~uniform(-1,3)"), axis_of("b~loguniform(1e-2,1e4)"),
                               axis_of("c~normal(5,0.5)"), axis_of("d=1,2")};
  const Members members(axes, 20'000, 7), same(axes, 20'000, 7), other(axes, 20'000, 8);
  ASSERT_EQ(members.size(), 40'000U);
  double mean_a = 0, mean_log_b = 0, mean_c = 0, square_c = 0;
  for (std::uint64_t member = 0; member < 20'000; ++member) {
    const std::vector<double> values = members.values(member);
    EXPECT_EQ(values, same.values(member));
    EXPECT_NE(values, other.values(member));
    EXPECT_TRUE(values[0] >= -1 && values[0] <= 3 && values[1] >= 1e-2 && values[1] <= 1e4);
    mean_a += values[0] / 20'000;
    mean_log_b += std::log10(values[1]) / 20'000;
    mean_c += values[2] / 20'000;
    square_c += (values[2] - 5) * (values[2] - 5) / 20'000;
  }
  // Five standard deviations of each mean: 1.155, 1.732, 0.5 and 0.354 over sqrt(20,000).
  EXPECT_NEAR(mean_a, 1, 0.041);
  EXPECT_NEAR(mean_log_b, 1, 0.062);
  EXPECT_NEAR(mean_c, 5, 0.018);
  EXPECT_NEAR(square_c, 0.25, 0.0125);
  // The same draws at each value of the grid.
  EXPECT_EQ(members.values(123)[3], 1);
  EXPECT_EQ(members.values(20'123)[3], 2);
  EXPECT_EQ(members.values(123)[0], members.values(20'123)[0]);
}

// The key of a draw held sixteen axes: the 17th of a draw had the value of the first of the next.
TEST(SweepMembers, NoAxisRepeatsAnother) {
  std::vector<Axis> axes;
  for (int k = 0; k < 40; ++k) axes.push_back(axis_of(fmt::format("k{}~uniform(0,1)", k)));
  const Members members(axes, 1000, 3);
  std::set<double> seen;
  for (std::uint64_t member = 0; member < 1000; ++member)
    for (const double value : members.values(member)) seen.insert(value);
  EXPECT_EQ(seen.size(), 40'000U);
}

TEST(SweepMembers, ATableIsReadWithItsLines) {
  const Members members = Members::of_csv("m.csv", "k,d\r\n1,2\n\n 3 ,-4e-2\n");
  ASSERT_EQ(members.size(), 2U);
  EXPECT_EQ(members.values(1), (std::vector<double>{3, -4e-2}));
}

void expect_refused(const char* part, const std::function<void()>& what) {
  try {
    what();
    ADD_FAILURE() << "nothing was refused; expected " << part;
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(SweepMembers, BadInputHasItsSentence) {
  for (const char* text : {"k", "=1..2:3", "k=1..2", "k=a,b", "k=1,nan", "k~normal(1)", "k~f(1,2)",
                           "k=1..2:3:4", "k=,1"})
    expect_refused("expected NAME=A..B:N", [&] { axis_of(text); });
  expect_refused("is empty", [] { axis_of("k=2..2:5"); });
  expect_refused("is empty", [] { axis_of("k~uniform(2,1)"); });
  expect_refused("no logarithm", [] { axis_of("k=0..2:log5"); });
  expect_refused("whole number", [] { axis_of("k=1..2:1"); });
  expect_refused("whole number", [] { axis_of("k=1..2:1e12"); });
  expect_refused("positive deviation", [] { axis_of("k~normal(1,0)"); });
  expect_refused("more than 10000000 members", [] {
    Members({axis_of("a=0..1:10000"), axis_of("b=0..1:10000"), axis_of("c=0..1:10000")}, 0, 1);
  });
  expect_refused("--sample N is missing", [] { Members({axis_of("k~uniform(0,1)")}, 0, 1); });
  expect_refused("no parameter has a distribution", [] { Members({axis_of("k=1,2")}, 5, 1); });
  expect_refused("twice", [] { Members({axis_of("k=1,2"), axis_of("k=3,4")}, 0, 1); });
  expect_refused("m.csv:3: d: got x", [] { Members::of_csv("m.csv", "k,d\n1,2\n3,x\n"); });
  expect_refused("m.csv:2: d: got nan", [] { Members::of_csv("m.csv", "k,d\n1,nan\n"); });
  expect_refused("m.csv:2: got 1 cells", [] { Members::of_csv("m.csv", "k,d\n1\n"); });
  expect_refused("no members", [] { Members::of_csv("m.csv", "k,d\n"); });
}

}  // namespace
}  // namespace odeum::sweep::members_test
