// SPDX-License-Identifier: BSD-3-Clause
// Computed references against those of cases/reference, which have 25 digits: what is claimed to be
// known is known.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/reference.hpp"
#include "odeum/cases/text_truth.hpp"
#include "odeum/truth/system.hpp"
#include "support/truth_problems.hpp"

namespace odeum::truth_test {
namespace {

cases::TextTruth computed_truth(const std::string& text) {
  return cases::truth_of(std::make_shared<const formula::TextOde>(formula::read_problem("f", text)),
                         {});
}

class ComputedTruth : public testing::TestWithParam<tests::TruthProblem> {};

TEST_P(ComputedTruth, ItsErrorIsBelowItsFloor) {
  const tests::TruthProblem& problem = GetParam();
  const auto ode =
      std::make_shared<const formula::TextOde>(formula::read_problem("f", problem.text));
  const cases::TextTruth truth = cases::truth_of(ode, {});
  const auto exact = cases::extended_truth(problem.reference);
  ASSERT_FALSE(truth.stops.empty()) << truth.words;
  const std::size_t n = problem.states;
  std::vector<long double> y(n), z(n);
  std::vector<double> rounded(n);
  long double scale = 0;
  for (const double stop : truth.stops) {
    ASSERT_TRUE(exact(stop, z.data())) << stop;
    ASSERT_TRUE(truth.extended(stop, y.data()) && truth.truth.at(stop, rounded.data())) << stop;
    // The reference is that of a decimal time, which the stop rounds to double.
    std::vector<long double> slope(n);
    ode->rhs_extended(stop, y.data(), slope.data());
    for (std::size_t i = 0; i < n; ++i) {
      const auto shift = static_cast<double>(std::abs(slope[i]) * 0x1p-53L * stop);
      scale = std::max(scale, std::abs(z[i]));
      EXPECT_LE(std::abs(y[i] - z[i]), truth.extended_floor + shift) << "t = " << stop << ", " << i;
      EXPECT_LE(std::abs(rounded[i] - z[i]), truth.truth.floor + shift)
          << "t = " << stop << ", " << i;
    }
  }
  if (problem.relative_floor > 0) {
    EXPECT_LE(truth.truth.floor, problem.relative_floor * static_cast<double>(scale))
        << truth.words;
  }
}

INSTANTIATE_TEST_SUITE_P(References, ComputedTruth, testing::ValuesIn(tests::truth_problems()),
                         [](const auto& instance) { return instance.param.name; });

TEST(TruthLimits, ChaosIsKnownToATime) {
  const cases::TextTruth truth = computed_truth(
      "states: {x: 1, y: 0, z: 0}\nequations: {x: 10*(y - x), y: x*(28 - z) - y, z: x*y - 8/3*z}\n"
      "time: {end: 100, stops: [10, 50, 100]}\n");
  EXPECT_EQ(truth.stops, std::vector<double>{10});
  // Errors grow as exp(0.9 t) from 5e-20.
  EXPECT_GT(truth.known_until, 25);
  EXPECT_LT(truth.known_until, 48);
  EXPECT_NE(truth.words.find("no verdict is given beyond"), std::string::npos) << truth.words;
}

TEST(TruthLimits, BlowUpIsKnownToItsTime) {
  // x = 1 / (1 - t)
  const cases::TextTruth truth =
      computed_truth("states: {x: 1}\nequations: {x: x^2}\ntime: {end: 2, stops: [0.5, 2]}\n");
  EXPECT_EQ(truth.stops, std::vector<double>{0.5});
  EXPECT_GT(truth.known_until, 0.9);
  EXPECT_LT(truth.known_until, 1);
  long double x = 0;
  ASSERT_TRUE(truth.extended(0.5, &x));
  EXPECT_NEAR(static_cast<double>(x), 2, truth.extended_floor);
  double y = 0;
  EXPECT_FALSE(truth.truth.at(0.99, &y)) << "not looked at";
  ASSERT_TRUE(truth.truth.at(1.01, &y));
  EXPECT_TRUE(std::isinf(y)) << "there is no solution";
  EXPECT_NE(truth.words.find("after t = 1 is wrong"), std::string::npos) << truth.words;
}

// x = sqrt(1 - 2 t) ends at 1/2 in zero, x = -log(1 - t) at 1, where it is 41 when steps vanish.
TEST(TruthLimits, ASolutionEndsWhereItsSlopeIsUnbounded) {
  for (const auto& [equation, end] :
       {std::pair{"-1/x", 0.5}, std::pair{"exp(x - 1)", 1.0}, std::pair{"x^1.5", 2.0}}) {
    const cases::TextTruth truth = computed_truth(
        fmt::format("states: {{x: 1}}\nequations: {{x: \"{}\"}}\ntime: {{end: 4}}\n", equation));
    double x = 0;
    ASSERT_TRUE(truth.truth.at(end + 0.01, &x)) << equation << ' ' << truth.words;
    EXPECT_TRUE(std::isinf(x)) << equation;
    EXPECT_FALSE(truth.truth.at(end - 0.01, &x) && std::isinf(x)) << equation;
  }
}

// Steps are short there too, but the slope is bounded: along x = 0 after t = 2, and beyond a jump.
TEST(TruthLimits, NoSolutionEndsAtAKink) {
  for (const char* equation : {"-sqrt(abs(x))", "if(x < 2, 1, 3)"}) {
    const cases::TextTruth truth = computed_truth(
        fmt::format("states: {{x: 1}}\nequations: {{x: \"{}\"}}\ntime: {{end: 4}}\n", equation));
    double x = 0;
    EXPECT_FALSE(truth.truth.at(3.99, &x) && std::isinf(x)) << equation << ' ' << truth.words;
  }
}

TEST(TruthLimits, TheRootOfANegativeNumberEndsWhatIsKnown) {
  // It is met at t = 1.
  const cases::TextTruth truth = computed_truth(
      "states: {y: 1, s: 0}\nequations: {y: -sqrt(1 - s), s: 1}\ntime: {end: 2, stops: [0.5, "
      "2]}\n");
  EXPECT_EQ(truth.stops, std::vector<double>{0.5});
  EXPECT_LE(truth.known_until, 1);
}

TEST(TruthLimits, KinksAreKnownToFewerDigits) {
  // x' = 1 where x < 1, else 3: x(2) = 1 + 3.
  const cases::TextTruth truth = computed_truth(
      "states: {x: 0}\nequations: {x: \"if(x < 1, 1, 3)\"}\ntime: {end: 2, stops: [2]}\n");
  ASSERT_FALSE(truth.stops.empty()) << truth.words;
  long double x = 0;
  ASSERT_TRUE(truth.extended(2, &x));
  EXPECT_LE(std::abs(static_cast<double>(x) - 4), truth.extended_floor) << truth.words;
}

TEST(TruthLimits, ImplicitAndExplicitMethodsAgree) {
  // Both families on a problem that both can solve, mildly stiff: y' = -50 (y - cos t).
  truth::System system;
  system.states = 1;
  system.y0 = {0};
  system.rhs = [](truth::Real t, const truth::Real* y, truth::Real* f) {
    f[0] = -50 * (y[0] - std::cos(t));
  };
  system.jacobian = [](truth::Real, const truth::Real*, truth::Real* j) { j[0] = -50; };
  const truth::Real t = 1.5L;
  const truth::Real exact = 2500.0L / 2501 * std::cos(t) + 50.0L / 2501 * std::sin(t) -
                            2500.0L / 2501 * std::exp(-50 * t);
  for (const truth::Method method : {truth::extrapolation_run, truth::verner_run, truth::radau_run,
                                     truth::implicit_extrapolation_run}) {
    const truth::Run run = method(system, {t}, {.tolerance = 1e-16L});
    ASSERT_EQ(run.states.size(), 1U) << run.end;
    // Some hundred steps of 1e-16 each, of which most is damped.
    EXPECT_NEAR(static_cast<double>(run.states[0][0] - exact), 0, 2e-15);
  }
}

TEST(TruthStore, IsReadBackOrRefused) {
  truth::Reference r;
  r.times = {0.1, 2};
  r.states = {{1 / 3.0L, -2e-30L}, {4, 5}};
  r.floors = {{1e-17, 3e-17}, {2e-16, 1e-15}};
  r.known_until = 2;
  r.ends_at = 3;
  r.methods = "two methods";
  const std::string text = truth::to_text(r);
  const auto read = truth::from_text(text, 2);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->times, r.times);
  EXPECT_EQ(read->states, r.states);
  EXPECT_EQ(read->floors, r.floors);
  EXPECT_EQ(read->ends_at, r.ends_at);
  EXPECT_EQ(truth::from_text(truth::to_text(truth::Reference{}), 2)->ends_at,
            std::numeric_limits<double>::infinity());
  EXPECT_EQ(truth::to_text(*read), text);
  EXPECT_FALSE(truth::from_text(text, 3));
  for (std::size_t size = 0; size + 1 < text.size(); ++size)
    EXPECT_FALSE(truth::from_text(text.substr(0, size), 2)) << size;
}

}  // namespace
}  // namespace odeum::truth_test
