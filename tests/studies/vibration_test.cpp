// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/studies/material/material.hpp"

namespace odeum::study::vibration_test {
namespace {

std::vector<double> damped_cosine(double w, double fall, double rest, double h, std::size_t count) {
  std::vector<double> z;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = h * static_cast<double>(i);
    z.push_back(rest + std::exp(-fall * t) * (std::cos(w * t) + fall / w * std::sin(w * t)));
  }
  return z;
}

TEST(Vibration, FindsAnOscillatorAtAnyResolution) {
  for (const double h : {0.001, 0.01, 0.1, 0.5}) {  // of 2 pi / 5 = 1.26 for a turn
    const Vibration found = fit_vibration(damped_cosine(5, 0.3, 0.01, h, 400), h);
    ASSERT_EQ(found.reason, "") << h;
    // The samples are of 1e-16; a lag of a sixth of a turn makes at most 1e3 times that of it.
    EXPECT_NEAR(found.omega_squared, 25 + 0.09, 1e-9) << h;
    EXPECT_NEAR(found.decay, 0.6, 1e-9) << h;
  }
}

TEST(Vibration, FindsOneThatCreeps) {
  std::vector<double> z;
  z.reserve(200);
  const double h = 0.02;  // rates 2 and 7: from rest, (7 exp(-2 t) - 2 exp(-7 t)) / 5
  for (int i = 0; i < 200; ++i)
    z.push_back((7 * std::exp(-2 * i * h) - 2 * std::exp(-7 * i * h)) / 5);
  const Vibration found = fit_vibration(z, h);
  ASSERT_EQ(found.reason, "");
  EXPECT_NEAR(found.omega_squared, 14, 1e-6);  // the faster part is e^-20 of the slower at the end
  EXPECT_NEAR(found.decay, 9, 1e-6);
}

TEST(Vibration, SaysWhyThereIsNone) {
  EXPECT_EQ(fit_vibration({1, 0, 0, 0, 0, 0}, 0.1).reason, "decays within a step");
  EXPECT_NE(fit_vibration({1, 0.1, 0.01, 0.001, 0.0001, 0, 0, 0, 0}, 0.1).reason, "");
  std::vector<double> flips;
  flips.reserve(30);
  for (int i = 0; i < 30; ++i) flips.push_back(std::pow(-0.8, i) + 0.5 * std::pow(-0.5, i));
  const std::string of_flips = fit_vibration(flips, 0.1).reason;
  EXPECT_NE(of_flips.find("changes sign"), std::string::npos) << of_flips;
  std::vector<double> halves;
  halves.reserve(12);
  for (int i = 0; i < 12; ++i) halves.push_back(std::pow(0.5, i));
  const std::string of_halves = fit_vibration(halves, 0.1).reason;
  EXPECT_NE(of_halves.find("overdamped"), std::string::npos) << of_halves;
}

}  // namespace
}  // namespace odeum::study::vibration_test
