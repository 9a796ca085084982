// SPDX-License-Identifier: BSD-3-Clause
// References that have to be done by a time.
#include <gtest/gtest.h>

#include <chrono>
#include <optional>

#include "odeum/core/clocks.hpp"
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

// Operations are counted as the system claims; a dearer right-hand side is bounded by the clock of
// the processor. The steps of 1/50 of the span would take 19 evaluations each, seconds in all.
TEST(Deadline, IsKeptByProcessorTimeWhereOperationsAreDearer) {
  truth::System system;
  system.states = 2;
  system.y0 = {1, 0};
  system.rhs = [](Real, const Real* y, Real* f) {
    const double start = processor_seconds();
    while (processor_seconds() - start < 1e-4) continue;
    f[0] = y[1];
    f[1] = -y[0];
  };
  const double start = processor_seconds();
  const truth::Run run = truth::verner_run(
      system, {1000}, {.tolerance = 1e-15L, .busy_until = start + 0.05, .seconds = 5});
  // A step that has begun is ended: 25 evaluations.
  EXPECT_LT(processor_seconds() - start, 0.2);
  EXPECT_TRUE(run.spent);
  EXPECT_NE(run.end.find("the 5 s of the processor are spent at t ="), std::string::npos)
      << run.end;
}

}  // namespace
}  // namespace odeum::deadline_test
