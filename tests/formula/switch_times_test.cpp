// SPDX-License-Identifier: BSD-3-Clause
// The times at which a text itself names a switch.
#include "odeum/formula/switch_times.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace odeum::switch_times_test {
namespace {

using Real = long double;
using Times = std::vector<Real>;

formula::SwitchTimes found_in(const std::string& equation, double end = 20) {
  const formula::Problem problem = formula::read_problem(
      "f", fmt::format("parameters: {{at: 1e-3, w: 5e-12}}\nstates: {{y: 0, z: 1}}\n"
                       "equations: {{y: \"{}\", z: -z}}\ntime: {{end: {}}}\n",
                       equation, end));
  return formula::switch_times(problem, end);
}
Real number(const char* text) { return std::strtold(text, nullptr); }

TEST(SwitchTimes, AreThoseThatTheTextNames) {
  EXPECT_EQ(found_in("if(t > 5, 1, 2)*y").times, Times{5});
  EXPECT_EQ(found_in("if(t < at, -y, -1e6*y)").times, Times{number("1e-3")});
  EXPECT_EQ(found_in("max(t - 3, 0) + min(2*t, 7) + abs(t - 19) + sign(t - 0.5)").times,
            (Times{0.5, 3, 3.5, 19}));
  EXPECT_EQ(found_in("if(t <= 30, 1, 2)").times, Times{}) << "after the end";
  EXPECT_EQ(found_in("if(t > 0, 1, 2)").times, Times{}) << "at the start";
  EXPECT_EQ(found_in("-y").times, Times{});
}

TEST(SwitchTimes, OfANarrowPulseAreApart) {
  const Real centre = number("7.3");
  for (const char* width : {"1e-3", "1e-9", "5e-12", "1e-15"}) {
    const Times times = found_in(fmt::format("if(abs(t - 7.3) < {}, 1e9, 0) - y", width)).times;
    ASSERT_EQ(times.size(), 3U) << width;
    const Real unit = 8 * 0x1p-63L;  // of the last place at 7.3
    EXPECT_NEAR(static_cast<double>((times[0] - (centre - number(width))) / unit), 0, 1);
    EXPECT_EQ(times[1], centre);
    EXPECT_NEAR(static_cast<double>((times[2] - (centre + number(width))) / unit), 0, 1);
  }
}

TEST(SwitchTimes, OfAPeriodicConditionAreAllOfThem) {
  const Times times = found_in("1e4*(max(sin(t), 0) - y)", 1000).times;
  ASSERT_EQ(times.size(), 318U);
  for (std::size_t k = 0; k < times.size(); ++k)
    EXPECT_NEAR(static_cast<double>(times[k] / (k + 1) - std::numbers::pi_v<Real>), 0, 1e-18);
  EXPECT_EQ(found_in("if(cos(2*pi*t) > 0.5, 1, 0)").times.size(), 40U);
}

// What depends on a state as well is not said by the text alone, and what switches ever faster has
// no last time before its end.
TEST(SwitchTimes, AreCompleteForTheNodesThatAreNamed) {
  EXPECT_TRUE(found_in("if(t > y, 1, 0)").nodes.empty());
  EXPECT_TRUE(found_in("max(sin(1/(20 - t)), 0)").nodes.empty());
  const formula::SwitchTimes one = found_in("if(t > y, 1, 0)*if(t > 2, 1, 0)");
  EXPECT_EQ(one.times, Times{2});
  EXPECT_EQ(one.nodes.size(), 1U);
}

}  // namespace
}  // namespace odeum::switch_times_test
