// SPDX-License-Identifier: BSD-3-Clause
// Growth measured on sequences of states known in closed form.
#include "odeum/judge/growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

namespace odeum::judge::growth_test {
namespace {

constexpr std::size_t count = 17;

std::vector<PlaneState> powers(std::complex<double> r, std::complex<double> s = 0,
                               double share = 0) {
  std::vector<PlaneState> states;
  for (std::size_t k = 0; k < count; ++k) {
    std::complex<double> y = std::pow(r, static_cast<double>(k));
    if (share != 0) y += share * std::pow(s, static_cast<double>(k));
    states.push_back({y.real(), y.imag()});
  }
  return states;
}

/// States of a symplectic map on the oscillator, from (w, 0).
std::vector<PlaneState> verlet(double w) {
  std::vector<PlaneState> states{{w, 0}};
  while (states.size() < count) {
    const auto [q, v] = states.back();
    states.push_back({(1 - w * w / 2) * q + w * v, -w * (1 - w * w / 4) * q + (1 - w * w / 2) * v});
  }
  return states;
}

TEST(Growth, OneRoot) {
  for (const std::complex<double> r :
       {std::complex<double>(0.5, 0), {-0.9, 0}, {0.6, 0.9}, {3, 4}}) {
    const Growth growth = dominant_growth(powers(r), Coefficients::complex);
    // std::pow of a complex number to the 16th is good to some 1e-15.
    EXPECT_NEAR(growth.log_per_step, std::log(std::abs(r)), 1e-14);
    EXPECT_LT(growth.noise, 1e-12);
  }
}

TEST(Growth, TwoRealRootsOfNearlyEqualSize) {
  // 0.97^k + 0.5 (-0.95)^k: the lengths alternate, the recurrence determines both roots. The fit
  // loses a few digits; the band is that of 16 equations with rounding errors of 1e-16.
  const Growth growth = dominant_growth(powers(0.97, -0.95, 0.5), Coefficients::complex);
  EXPECT_NEAR(growth.log_per_step, std::log(0.97), 1e-13);
  EXPECT_LT(growth.noise, 1e-11);
  EXPECT_TRUE(growth.decays());
}

TEST(Growth, SymplecticMapsAreNeutralUpToTheirLimit) {
  for (const double w : {1e-3, 0.05, 0.5, 1.0, 1.9, 1.9999, 2 - 1e-7}) {
    const Growth growth = dominant_growth(verlet(w), Coefficients::real);
    EXPECT_FALSE(growth.grows()) << w << ' ' << growth.log_per_step << ' ' << growth.noise;
    EXPECT_FALSE(growth.decays()) << w << ' ' << growth.log_per_step << ' ' << growth.noise;
    EXPECT_LT(growth.noise, 1e-6) << w;
  }
}

TEST(Growth, SymplecticMapsGrowBeyondIt) {
  // The half trace is -(1 + d) with d = (w^2 - 4)/2, and the larger root 1 + d + sqrt(2 d + d^2).
  for (const double excess : {1e-7, 1e-5, 1e-2}) {
    const double w = 2 + excess, d = (w * w - 4) / 2;
    const Growth growth = dominant_growth(verlet(w), Coefficients::real);
    EXPECT_TRUE(growth.grows()) << excess;
    // Next to a double root rounding enters through a square root: within a thousandth here.
    EXPECT_NEAR(growth.log_per_step / std::log(1 + d + std::sqrt(2 * d + d * d)), 1, 1e-3);
  }
}

TEST(Growth, NoiseCoversWhatThreeRootsHide) {
  std::vector<PlaneState> states;
  for (std::size_t k = 0; k < count; ++k) {
    const auto n = static_cast<double>(k);
    const auto y = std::pow(std::complex<double>(0.0, 1.001), n) +
                   0.5 * std::pow(std::complex<double>(0.9, 0.3), n) + 0.7 * std::pow(-0.98, n);
    states.push_back({y.real(), y.imag()});
  }
  const Growth growth = dominant_growth(states, Coefficients::complex);
  EXPECT_GT(growth.noise, std::abs(growth.log_per_step - std::log(1.001)));
}

}  // namespace
}  // namespace odeum::judge::growth_test
