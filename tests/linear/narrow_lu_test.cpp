// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/narrow_lu.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <random>

namespace odeum::narrow_lu_test {
namespace {

template <bool is_complex, std::size_t width>
void expect_solves(std::size_t n) {
  std::mt19937 random(5);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same matrices each time
  std::uniform_real_distribution<double> any(-1, 1);
  linear::NarrowLu<is_complex, width> lu(n);
  lu.clear();
  std::vector<int> order(n);  // the last first
  for (std::size_t k = 0; k < n; ++k) order[k] = static_cast<int>(n - 1 - k);
  std::vector<std::complex<double>> a(n * n), b(n);
  std::vector<double> re(n), im(n);
  for (std::size_t i = 0; i < n; ++i) {
    b[i] = {any(random), is_complex ? any(random) : 0};
    re[n - 1 - i] = b[i].real(), im[n - 1 - i] = b[i].imag();
    for (std::size_t j = i < width ? 0 : i - width; j <= std::min(n - 1, i + width); ++j) {
      a[i * n + j] = {any(random) + (i == j ? 10 : 0), is_complex ? any(random) : 0};
      lu.re()[lu.place(i, j)] = a[i * n + j].real();
      if (is_complex) lu.im()[lu.place(i, j)] = a[i * n + j].imag();
    }
  }
  ASSERT_TRUE(lu.factorise());
  lu.solve(re.data(), is_complex ? im.data() : nullptr, order.data());
  for (std::size_t i = 0; i < n; ++i) {
    std::complex<double> rest = b[i];
    for (std::size_t j = 0; j < n; ++j)
      rest -= a[i * n + j] * std::complex(re[n - 1 - j], is_complex ? im[n - 1 - j] : 0);
    // The solution is below 0.3, so that terms are below 3 and their roundings below 1e-15.
    EXPECT_LE(std::abs(rest), 1e-14) << width << ' ' << n << ' ' << i;
  }
}

// The middle has as many rows as the band is wide, or one more.
TEST(NarrowLu, SolvesFromBothEnds) {
  for (const std::size_t n : {12, 13, 40, 41}) {
    expect_solves<false, 1>(n);
    expect_solves<false, 2>(n);
    expect_solves<false, 3>(n);
    expect_solves<true, 1>(n);
    expect_solves<true, 2>(n);
    expect_solves<true, 3>(n);
  }
}

// In either chain; the one row of the middle comes last, with none below it.
TEST(NarrowLu, RefusesAPivotThatAnExchangeWouldReplace) {
  constexpr std::size_t n = 13;
  for (std::size_t small = 0; small < n; ++small) {
    linear::NarrowLu<false, 1> lu(n);
    lu.clear();
    for (std::size_t i = 0; i < n; ++i) {
      lu.re()[lu.place(i, i)] = i == small ? 0.5 : 4;
      if (i > 0) lu.re()[lu.place(i, i - 1)] = lu.re()[lu.place(i - 1, i)] = 1;
    }
    EXPECT_EQ(lu.factorise(), small == n / 2) << small;
  }
}

}  // namespace
}  // namespace odeum::narrow_lu_test
