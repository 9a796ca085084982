// SPDX-License-Identifier: BSD-3-Clause
// The closed form of the damped oscillator, the truth of its cases, against independent ones.
#include "odeum/problem/damped_oscillator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <vector>

#include "odeum/cases/reference.hpp"

namespace odeum::tests::damped_oscillator_test {
namespace {

double distance(const double* a, const double* b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

struct ReferenceRun {
  const char* name;
  double damping;
  friend std::ostream& operator<<(std::ostream& out, const ReferenceRun& r) {
    return out << r.name;
  }
};

class AgainstReference : public testing::TestWithParam<ReferenceRun> {};

// 25-digit solutions of x'' + c x' + x = 0, x(0) = 1, x'(0) = 1/2.
TEST_P(AgainstReference, HasThirteenDigits) {
  const Truth truth = cases::reference_truth(GetParam().name, 0);
  for (const double t : {0.5, 1.0, 5.0, 10.0, 20.0}) {
    double exact[2], state[2];
    ASSERT_TRUE(truth.at(t, exact));
    damped_oscillator_solution(1, GetParam().damping, 1, 1, 0.5, t, state);
    // The header promises thirteen digits.
    EXPECT_LE(distance(state, exact), 1e-13 * std::hypot(exact[0], exact[1])) << "t = " << t;
  }
}

INSTANTIATE_TEST_SUITE_P(DampedOscillator, AgainstReference,
                         testing::Values(ReferenceRun{"osc_undamped", 0},
                                         ReferenceRun{"osc_under", 0.2},
                                         ReferenceRun{"osc_critical", 2},
                                         ReferenceRun{"osc_nearcrit_above_1e-6", 2.000002},
                                         ReferenceRun{"osc_over", 4}),
                         [](const auto& run) {
                           std::string name = run.param.name;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

/// The same solution in long double, from the power series of cosh(st) and sinh(st)/s in (st)^2
/// where that is below one (no root is taken, nothing cancels), from the functions themselves
/// elsewhere.
void long_double_solution(long double m, long double d, long double k, long double y0,
                          long double v0, long double t, double* state) {
  const long double beta = d / (2 * m), z = (d * d - 4 * m * k) / (4 * m * m) * t * t;
  long double c = 1, s = 1;  // cosh(st), sinh(st) / (st)
  if (std::abs(z) < 1) {
    long double term_c = 1, term_s = 1;
    for (int n = 1; n <= 12; ++n) {  // 1 / 24! is below the rounding of any long double
      term_c *= z / static_cast<long double>((2 * n - 1) * (2 * n));
      term_s *= z / static_cast<long double>((2 * n) * (2 * n + 1));
      c += term_c;
      s += term_s;
    }
  } else {
    const long double root = std::sqrt(std::abs(z));
    c = z > 0 ? std::cosh(root) : std::cos(root);
    s = (z > 0 ? std::sinh(root) : std::sin(root)) / root;
  }
  const long double decay = std::exp(-beta * t);
  state[0] = static_cast<double>(decay * (y0 * c + (v0 + beta * y0) * t * s));
  state[1] = static_cast<double>(decay * (v0 * c - (beta * v0 + k / m * y0) * t * s));
}

TEST(DampedOscillator, KeepsItsDigitsOnBothSidesOfCriticalDamping) {
  if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double is double here";
  for (const double m : {1.0, 1.3, 7e-3}) {
    for (const double stiffness : {5.0, 1.7, 2.9e2}) {
      const double critical = 2 * std::sqrt(stiffness * m);
      const double unit = std::sqrt(m / stiffness);  // s; makes y and y' comparable
      for (int exponent = 1; exponent <= 16; ++exponent) {
        for (const double side : {-1.0, 1.0}) {
          const double damping = critical * (1 + side * std::pow(10.0, -exponent));
          for (const double periods : {0.1, 1.0, 3.0, 10.0}) {
            const double t = periods * unit, y0 = -5, v0 = 2 / unit;
            double state[2], exact[2];
            damped_oscillator_solution(m, damping, stiffness, y0, v0, t, state);
            long_double_solution(m, damping, stiffness, y0, v0, t, exact);
            // Relative to the size of the state, as promised; the velocity in units of y / unit.
            const double size = std::hypot(exact[0], exact[1] * unit);
            EXPECT_NEAR(state[0], exact[0], 1e-13 * size)
                << "m " << m << " k " << stiffness << " side " << side << " 1e-" << exponent;
            EXPECT_NEAR(state[1] * unit, exact[1] * unit, 1e-13 * size)
                << "m " << m << " k " << stiffness << " side " << side << " 1e-" << exponent;
          }
        }
      }
    }
  }
}

TEST(DampedOscillator, SatisfiesItsEquation) {
  // y'' from a central difference of y': the error of the difference is O(delta^2) = 1e-8 |y''''|,
  // its rounding epsilon / delta = 1e-12.
  const double m = 2, d = 0.7, k = 3, delta = 1e-4;
  for (const double t : {0.3, 2.0, 9.0}) {
    double before[2], now[2], after[2];
    damped_oscillator_solution(m, d, k, 1, -2, t - delta, before);
    damped_oscillator_solution(m, d, k, 1, -2, t, now);
    damped_oscillator_solution(m, d, k, 1, -2, t + delta, after);
    EXPECT_NEAR((after[0] - before[0]) / (2 * delta), now[1], 3e-8);
    EXPECT_NEAR(m * (after[1] - before[1]) / (2 * delta) + d * now[1] + k * now[0], 0, 3e-8);
  }
}

TEST(DampedOscillator, DecaysToZeroWithoutOverflowWhenStrongly) {
  double state[2];
  damped_oscillator_solution(1, 1e6, 1, 1, 0, 1e3, state);  // cosh(s t) alone would overflow
  // The slow root is -k/d (1 + k m / d^2 + ...), the fast part has decayed.
  EXPECT_NEAR(state[0], std::exp(-1e-3), 1e-11);  // k m / d^2 = 1e-12, twice
  damped_oscillator_solution(1, 10, 1, 1, 0, 1e6, state);
  EXPECT_EQ(state[0], 0);
  EXPECT_EQ(state[1], 0);
}

}  // namespace
}  // namespace odeum::tests::damped_oscillator_test
