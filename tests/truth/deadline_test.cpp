// SPDX-License-Identifier: BSD-3-Clause
// References that have to be done by a time.
#include <gtest/gtest.h>

#include <chrono>

#include "odeum/truth/system.hpp"

namespace odeum::deadline_test {
namespace {

using std::chrono::steady_clock;
using truth::Real;

truth::Reference oscillator(const TruthBounds& bounds = {}) {
  truth::System system;
  system.states = 2;
  system.y0 = {1, 0};
  system.rhs = [](Real, const Real* y, Real* f) {
    f[0] = y[1];
    f[1] = -y[0];
  };
  return truth::compute_reference(system, {1, 2}, {}, bounds);
}

// What is tried first, so that something is known in any case, must not move what is found in time.
TEST(Deadline, DoesNotMoveWhatIsFoundInTime) {
  const truth::Reference without = oscillator();
  const truth::Reference with = oscillator({.until = steady_clock::now() + std::chrono::hours(1)});
  ASSERT_EQ(with.times, without.times);
  EXPECT_EQ(with.states, without.states);
  EXPECT_EQ(with.floors, without.floors);
}

TEST(Deadline, EndsWhatIsNotFoundInTime) {
  const truth::Reference late =
      oscillator({.until = steady_clock::now() - std::chrono::seconds(1)});
  EXPECT_TRUE(late.times.empty());
  EXPECT_NE(late.end.find("the seconds are spent"), std::string::npos) << late.end;
}

}  // namespace
}  // namespace odeum::deadline_test
