// SPDX-License-Identifier: BSD-3-Clause
// The conditions of additive Runge-Kutta methods see each coefficient, and how the halves couple.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/methods/ark32_kennedy_carpenter.hpp"
#include "odeum/methods/ark43_kennedy_carpenter.hpp"
#include "odeum/methods/ars222.hpp"
#include "odeum/methods/ars443.hpp"

namespace odeum::additive_tableau_test {
namespace {

/// Alters each coefficient that is not zero in turn, and expects the conditions to fail.
template <std::size_t S>
int expect_each_seen(const AdditiveTableau<S>& sound) {
  EXPECT_EQ(first_fault(sound).order, 0);
  int seen = 0;
  for (const bool implicit : {false, true}) {
    const auto alter = [&](auto&& entry) {
      for (const double size : {1e-9, 1e-3, -2.0}) {  // the last: the other sign
        AdditiveTableau<S> mutant = sound;
        double& value = entry(implicit ? mutant.implicit_half : mutant.explicit_half);
        if (value == 0) return;
        value *= 1 + size;
        EXPECT_NE(first_fault(mutant).order, 0) << implicit << ' ' << value << ' ' << size;
        ++seen;
      }
    };
    for (std::size_t i = 0; i < S; ++i) {
      for (std::size_t j = 0; j < S; ++j)
        alter([&](Tableau<S>& half) -> double& { return half.a[i][j]; });
      alter([&](Tableau<S>& half) -> double& { return half.b[i]; });
      alter([&](Tableau<S>& half) -> double& { return half.b_hat[i]; });
    }
  }
  return seen;
}

TEST(AdditiveTableau, EachCoefficientIsSeen) {
  EXPECT_GE(expect_each_seen(methods::ars222_tableau), 30);
  EXPECT_GE(expect_each_seen(methods::ars443_tableau), 60);
  EXPECT_GE(expect_each_seen(methods::ark32_kennedy_carpenter_tableau), 90);
  EXPECT_GE(expect_each_seen(methods::ark43_kennedy_carpenter_tableau), 150);
}

// Each half has order 3 by itself, on the same nodes. The last stage of the explicit half has no
// weight there, so that only the weights of the implicit half see it.
TEST(AdditiveTableau, HalvesThatDoNotCoupleAreNoPair) {
  AdditiveTableau<5> pair = methods::ars443_tableau;
  pair.explicit_half.a[4][1] += 0.1;
  pair.explicit_half.a[4][2] -= 0.1;
  EXPECT_EQ(order_fault(pair.explicit_half, pair.explicit_half.b, 3).order, 0);
  EXPECT_EQ(order_fault(pair.implicit_half, pair.implicit_half.b, 3).order, 0);
  EXPECT_EQ(first_fault(pair).order, 3);
}

TEST(AdditiveTableau, BothPartsAreEvaluatedAtTheSameTimes) {
  AdditiveTableau<4> pair = methods::ark32_kennedy_carpenter_tableau;
  pair.explicit_half.a[2][0] += 0.01;
  EXPECT_FALSE(pair.has_common_nodes());
  EXPECT_EQ(first_fault(pair).order, 2);
}

TEST(AdditiveTableau, NoOrderAboveOrBelowItsOwnIsProven) {
  AdditiveTableau<3> pair = methods::ars222_tableau;
  pair.order = 3;
  EXPECT_EQ(first_fault(pair).order, 3);
  pair.order = 1;
  EXPECT_EQ(first_fault(pair).order, 2);
  pair.order = 2;
  pair.explicit_half.b = {1, 0, 0};
  EXPECT_EQ(first_fault(pair).order, 2);
}

TEST(AdditiveTableau, TheSameTableauTwiceIsThatMethod) {
  AdditiveTableau<4> twice;
  twice.explicit_half = {.a = {{{0}, {0.5}, {0, 0.5}, {0, 0, 1}}},
                         .b = {1. / 6, 1. / 3, 1. / 3, 1. / 6}};
  twice.implicit_half = twice.explicit_half;
  twice.order = 4;
  EXPECT_EQ(first_fault(twice).order, 0);
}

}  // namespace
}  // namespace odeum::additive_tableau_test
