// SPDX-License-Identifier: BSD-3-Clause
// References that have to be done by a time.
#include <gtest/gtest.h>

#include <chrono>
#include <optional>

#include "odeum/truth/system.hpp"

namespace odeum::deadline_test {
namespace {

using std::chrono::steady_clock;
using truth::Real;

truth::Reference oscillator() {
  truth::System system;
  system.states = 2;
  system.y0 = {1, 0};
  system.rhs = [](Real, const Real* y, Real* f) {
    f[0] = y[1];
    f[1] = -y[0];
  };
  return truth::compute_reference(system, {1, 2}, {});
}

// What is tried first, so that something is known in any case, must not move what is found in time.
TEST(Deadline, DoesNotMoveWhatIsFoundInTime) {
  const truth::Reference without = oscillator();
  const truth::Deadline deadline(steady_clock::now() + std::chrono::hours(1));
  const truth::Reference with = oscillator();
  ASSERT_EQ(with.times, without.times);
  EXPECT_EQ(with.states, without.states);
  EXPECT_EQ(with.floors, without.floors);
}

TEST(Deadline, EndsWhatIsNotFoundInTime) {
  std::optional<truth::Deadline> deadline(steady_clock::now() - std::chrono::seconds(1));
  const truth::Reference late = oscillator();
  EXPECT_TRUE(late.times.empty());
  EXPECT_NE(late.end.find("the seconds are spent"), std::string::npos) << late.end;
  // It ends with what asked for it.
  deadline.reset();
  EXPECT_TRUE(oscillator().end.empty());
}

}  // namespace
}  // namespace odeum::deadline_test
