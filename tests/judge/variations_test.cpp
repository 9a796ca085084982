// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/variations.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "odeum/judge/amplification.hpp"
#include "support/catalogue.hpp"
#include "support/hybrid_text.hpp"

namespace odeum::judge::variations_test {
namespace {

// Over periods of Kepler's problem errors grow in proportion to the time; the errors of matrices of
// differences made that 9.1e19 after a hundred periods. Computed apart by SciPy's DOP853 at 1e-13
// on the variational equations, the largest over 2001 times: 249,982.
TEST(Amplification, OfAnOrbitGrowsInProportionToTheTime) {
  const Case& c = tests::find_case("kepler_e06");
  const Amplification found = measure_amplification(c, c.timed_stops());
  ASSERT_EQ(found.unknown, "");
  EXPECT_NEAR(found.at_stops.back(), 249'982, 2500);
}

// exp(A t) of x'' = -x, and of a third component that is twice the first: J has no full rank.
TEST(Variations, AreTheMatrixExponential) {
  const tests::HybridText text(
      "states: {x: 1, v: 0, s: 0}\nequations: {x: v, v: -x, s: 2*v}\ntime: {end: 2}\n");
  Case c;
  c.problem = text.contest;
  const std::vector<double> all = with_variations(c, 0.5, {1, 0, 0}, 2, 1e-12, {1, 1, 1});
  const double cosine = std::cos(1.5), sine = std::sin(1.5);
  const std::vector<double> expected{cosine, -sine, 2 * (cosine - 1), cosine,   sine, 0, -sine,
                                     cosine, 0,     2 * (cosine - 1), 2 * sine, 1};
  ASSERT_EQ(all.size(), expected.size());
  for (std::size_t k = 0; k < all.size(); ++k) EXPECT_NEAR(all[k], expected[k], 1e-11) << k;
}

// The slope jumps from 1 to -50 where x reaches 0.5, at sqrt(2) - 1 with a velocity of sqrt(2): a
// start that is farther by d gets there d / sqrt(2) earlier, which changes v by 51 d / sqrt(2). J
// sees nothing of that, and a run beside the solution does. sqrt(2) 36.06 (1 + |x|) from just
// before that time, 64.5 from the start.
TEST(Amplification, IsThatOfRunsWhereASlopeJumps) {
  const tests::HybridText text(
      "states: {x: 0, v: 1}\nequations: {x: v, v: 'if(x > 0.5, -50, 1)'}\ntime: {end: 0.45}\n");
  Case c;
  c.y0 = {0, 1};
  c.stops = {0.45};
  c.problem = text.contest;
  c.truth.at = [](double t, double* y) {
    const double root = std::sqrt(2.0), after = t - (root - 1);
    y[0] = 0.5 + root * after - 25 * after * after, y[1] = root - 50 * after;
    return true;
  };
  const Amplification found = measure_amplification(c, c.stops);
  ASSERT_EQ(found.unknown, "");
  EXPECT_GT(found.at_stops.back(), 64);
  EXPECT_LT(found.at_stops.back(), 78);
}

// A power that is not an integer, of a state that begins at 0: a run from below has no value.
TEST(Amplification, IsMeasuredWithinTheDomain) {
  const tests::HybridText text(
      "states: {m: 0, p: 0}\nequations: {m: 0.03 + 2*p^1.7/(0.4 + p^1.7) - m, p: m - 0.4*p}\n"
      "time: {end: 1}\n");
  Case c;
  c.y0 = {0, 0};
  c.stops = {1};
  c.problem = text.contest;
  const std::vector<double> end = text.run("odeum/dormand_prince853", 1e-12).states;
  c.truth.at = [&](double, double* y) {
    y[0] = end.end()[-2], y[1] = end.end()[-1];
    return true;
  };
  EXPECT_EQ(measure_amplification(c, c.stops).unknown, "");
}

}  // namespace
}  // namespace odeum::judge::variations_test
