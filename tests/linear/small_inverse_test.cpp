// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/small_inverse.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace odeum::tests::small_inverse_test {
namespace {

/// Entries in [-1/2, 1/2), the same in every run.
struct Entries {
  std::uint32_t state = 7;
  double operator()() {
    state = state * 1664525U + 1013904223U;
    return static_cast<double>(state) / 4294967296.0 - 0.5;
  }
};

// With `shift` on the diagonal after rows were turned by `turn`: a turned matrix needs pivots.
template <std::size_t N>
void expect_solved(Entries& entry, double shift, std::size_t turn) {
  linear::SmallInverse<N> inverse;
  std::array<double, N * N> a{};
  std::array<double, N> x{}, b{};
  for (std::size_t i = 0; i < N; ++i) {
    x[i] = entry();
    for (std::size_t j = 0; j < N; ++j) a[i * N + j] = entry() + ((i + turn) % N == j ? shift : 0);
  }
  for (std::size_t i = 0; i < N; ++i)
    for (std::size_t j = 0; j < N; ++j) b[i] += a[i * N + j] * x[j];
  std::copy(a.begin(), a.end(), inverse.data());
  ASSERT_TRUE(inverse.factorise()) << N;
  inverse.solve(b.data());
  // Rounding of N products, a condition number below 100, and two digits to a multiplier of 100.
  for (std::size_t i = 0; i < N; ++i) EXPECT_NEAR(b[i], x[i], 1e-11) << N << ", turned by " << turn;

  inverse.data()[N * N - 1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(inverse.factorise()) << N << ": not finite";
  std::fill(inverse.data(), inverse.data() + N * N, 1.0);
  EXPECT_EQ(inverse.factorise(), N == 1) << N << ": singular";
}

TEST(SmallInverse, SolvesWithAndWithoutPivots) {
  Entries entry;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (expect_solved<I + 1>(entry, 2.0 * (I + 1), 0), ...);
    (expect_solved<I + 1>(entry, 2.0 * (I + 1), 1), ...);
  }
  (std::make_index_sequence<linear::small_inverse_limit>());
}

}  // namespace
}  // namespace odeum::tests::small_inverse_test
