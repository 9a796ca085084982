// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/catalogue.hpp"
#include "odeum/judge/amplification.hpp"

namespace odeum::judge::rounding_test {
namespace {

// No number of steps within the bounds of the study meets every stop of some cases.
TEST(Rounding, HasAGainForEveryCase) {
  for (const Case& c : all_cases()) {
    const double gain = perturbation_gain(c);
    EXPECT_TRUE(std::isfinite(gain) && gain > 0) << c.id << ": " << gain;
  }
}

}  // namespace
}  // namespace odeum::judge::rounding_test
