// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/isolated/kept_arithmetic.hpp"

#include <gtest/gtest.h>

#include <cfenv>
#include <limits>

namespace odeum::kept_arithmetic_test {
namespace {

bool flushes() {
  const volatile double small = std::numeric_limits<double>::min();
  return small / 4 == 0;
}

TEST(KeptArithmetic, IsAtTheEndAsAtTheStart) {
  const int rounding = std::fegetround();
  {
    const isolated::KeptArithmetic kept;
    std::fesetround(FE_DOWNWARD);
#if defined(__SSE2__)
    _mm_setcsr(_mm_getcsr() | 0x8040U);  // flush to zero, and take subnormal numbers for it
    EXPECT_TRUE(flushes());
#endif
    EXPECT_EQ(std::fegetround(), FE_DOWNWARD);
  }
  EXPECT_EQ(std::fegetround(), rounding);
  EXPECT_FALSE(flushes());
  const volatile long double one = 1, three = 3;
  EXPECT_EQ((one / three) * three, 1.0L) << "in the extended registers, too";
}

}  // namespace
}  // namespace odeum::kept_arithmetic_test
