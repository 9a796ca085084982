// SPDX-License-Identifier: BSD-3-Clause
// All zeros of functions whose zeros are known.
#include "odeum/control/zeros.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace odeum::tests::zeros_test {
namespace {

struct Found {
  std::vector<double> times;
  std::vector<int> senses;
  int evaluations = 0;
};

/// The zeros of g along steps that end at the given times.
Found zeros(const std::function<double(double)>& g, const std::vector<double>& ends) {
  Found found;
  const auto counted = [&](double t) { return ++found.evaluations, g(t); };
  ZeroSearch search;
  search.begin();
  for (std::size_t k = 1; k < ends.size(); ++k)
    search(counted, ends[k - 1], g(ends[k - 1]), ends[k], g(ends[k]), [&](const Zero& zero) {
      found.times.push_back(zero.t);
      found.senses.push_back(zero.sense);
      return false;
    });
  return found;
}

void expect_times(const Found& found, const std::vector<double>& exact, double within) {
  ASSERT_EQ(found.times.size(), exact.size());
  for (std::size_t k = 0; k < exact.size(); ++k) EXPECT_NEAR(found.times[k], exact[k], within) << k;
}

double cubic(double t) { return (t + 6) * (t + 2) * (t - 2); }

TEST(Zeros, OfACubicWithinOneStep) {
  const Found three = zeros(cubic, {-100, 100});
  expect_times(three, {-6, -2, 2}, 1e-12);
  EXPECT_EQ(three.senses, (std::vector<int>{1, -1, 1}));
  expect_times(zeros(cubic, {-5.9, 2.5}), {-2, 2}, 1e-13);
  expect_times(zeros(cubic, {-5.9, 1e6}), {-2, 2}, 1e-8);  // 4 roundings of the end
}

TEST(Zeros, OfPolynomialsWithRandomRoots) {
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> in(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> roots(1 + trial % 6);
    for (double& root : roots) root = in(random);
    std::ranges::sort(roots);
    bool apart = true;  // the condition of a root is 1 / (its distances from the others)
    for (std::size_t k = 1; k < roots.size(); ++k) apart = apart && roots[k] - roots[k - 1] > 1e-3;
    if (!apart) continue;
    const auto g = [&](double t) {
      double product = 1;
      for (const double root : roots) product *= t - root;
      return product;
    };
    expect_times(zeros(g, {0, 1}), roots, 1e-9);
  }
}

TEST(Zeros, OfAnOscillationInOneStepAndInMany) {
  std::vector<double> exact;
  for (int k = 0; k < 100; ++k) exact.push_back((k + 0.5) * M_PI / 10);
  const auto g = [](double t) { return std::cos(10 * t); };
  expect_times(zeros(g, {0, 10 * M_PI}), exact, 1e-13);
  std::vector<double> ends;
  for (int k = 0; k <= 77; ++k) ends.push_back(k * 10 * M_PI / 77);
  expect_times(zeros(g, ends), exact, 1e-13);
}

TEST(Zeros, TouchesAndWhatNearlyTouches) {
  const auto touch = [](double depth) {
    return [depth](double t) { return (t - 0.3) * (t - 0.3) * std::exp(t) - depth * depth; };
  };
  const Found touches = zeros(touch(0), {0, 1});
  expect_times(touches, {0.3}, 1e-6);  // g is rounding within 1e-8 of the step
  EXPECT_EQ(touches.senses, std::vector<int>{0});
  // Two crossings 2e-5 apart, about 0.3.
  const Found two = zeros(touch(1e-5), {0, 1});
  ASSERT_EQ(two.times.size(), 2U);
  EXPECT_NEAR(two.times[1] - two.times[0], 2e-5 * std::exp(-0.15), 1e-9);
  const auto above = [](double t) { return (t - 0.3) * (t - 0.3) + 1e-10; };
  EXPECT_TRUE(zeros(above, {0, 1}).times.empty());
}

TEST(Zeros, AtTheEndsOfSteps) {
  // Zero where the run begins is none of its zeros, with rounding or without.
  for (const double rounding : {0.0, 1e-17, -1e-17}) {
    const auto thrown = [=](double t) { return rounding + t - t * t; };
    expect_times(zeros(thrown, {0, 0.5, 2}), {1}, 1e-15);
  }
  const auto g = [](double t) { return t - 0.5; };
  expect_times(zeros(g, {0, 0.5, 1}), {0.5}, 0);
  expect_times(zeros(g, {0, std::nextafter(0.5, 0), 1}), {0.5}, 1e-15);
  expect_times(zeros(g, {0, std::nextafter(0.5, 1), 1}), {0.5}, 1e-15);
}

TEST(Zeros, AtTheEndOfTheLastStep) {
  expect_times(zeros([](double t) { return t - 1; }, {0, 0.5, 1}), {1}, 0);
  expect_times(zeros([](double t) { return 1 - t; }, {0, 1}), {1}, 0);
}

TEST(Zeros, JumpsAndValuesThatAreNotThere) {
  const auto jump = [](double t) { return t < 0.7 ? -1.0 : 1.0; };
  expect_times(zeros(jump, {0, 1}), {0.7}, 1e-12);
  const auto pole = [](double t) { return t < 0.5 ? std::nan("") : t - 0.75; };
  expect_times(zeros(pole, {0, 0.6, 1}), {0.75}, 1e-15);
}

TEST(Zeros, RoundingJustAfterAZeroIsNone) {
  // 0.2 - 0.1 t^2 from 0.2, rounded upwards and downwards in turn
  int turn = 0;
  const auto g = [&](double t) { return -0.1 * t * t + (++turn % 2 ? 3e-17 : -3e-17); };
  int found = 0;
  ZeroSearch search;
  search.begin();
  search.round_within(1e-15);
  for (const auto& [a, b] : {std::pair{0.0, 1e-6}, {1e-6, 1e-3}, {1e-3, 1.0}})
    search(g, a, g(a), b, g(b), [&](const Zero&) { return ++found, false; });
  EXPECT_EQ(found, 0);
}

TEST(Zeros, ARunThatWasMadeUpToAZeroLeavesIt) {
  // Another run to the zero ended before it, by its own error.
  const auto g = [](double t) { return std::sin(t) - 1e-6; };
  std::vector<double> times;
  ZeroSearch search;
  search.begin(true, 2e-6);
  for (const auto& [a, b] : {std::pair{0.0, 1e-7}, {1e-7, 1e-5}, {1e-5, 4.0}})
    search(g, a, g(a), b, g(b), [&](const Zero& zero) { return times.push_back(zero.t), false; });
  ASSERT_EQ(times.size(), 1U);
  EXPECT_NEAR(times[0], M_PI - 1e-6, 1e-12);
}

TEST(Zeros, NoiseAloneEnds) {
  std::mt19937_64 random(1);
  const auto noise = [&](double) { return std::ldexp(static_cast<double>(random() % 3) - 1, -50); };
  EXPECT_LT(zeros(noise, {0, 1}).evaluations, 1'000'000);
}

TEST(Zeros, AStepWithoutOneTakesThreeValuesWithin) {
  EXPECT_EQ(zeros([](double t) { return std::exp(-t); }, {0, 1}).evaluations, 3);
}

}  // namespace
}  // namespace odeum::tests::zeros_test
