// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/banded_lu.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <random>

namespace odeum::banded_lu_test {
namespace {

// Narrow bands without exchanges of rows have a solution of their own.
template <bool is_complex>
void expect_bands_solved(double diagonal) {
  std::mt19937 random(5);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same matrices each time
  std::uniform_real_distribution<double> any(-1, 1);
  for (const std::size_t width : {1, 2, 3, 4})
    for (const std::size_t n : {5, 6, 40}) {
      linear::BandedLu<is_complex> lu(n, width, width);
      lu.clear();
      std::vector<std::complex<double>> a(n * n), b(n);
      std::vector<double> re(n), im(n);
      for (std::size_t i = 0; i < n; ++i) {
        b[i] = {any(random), is_complex ? any(random) : 0};
        re[i] = b[i].real(), im[i] = b[i].imag();
        for (std::size_t j = i < width ? 0 : i - width; j <= std::min(n - 1, i + width); ++j) {
          a[i * n + j] = {any(random) + (i == j ? diagonal : 0), is_complex ? any(random) : 0};
          lu.re()[lu.place(i, j)] = a[i * n + j].real();
          if (is_complex) lu.im()[lu.place(i, j)] = a[i * n + j].imag();
        }
      }
      ASSERT_TRUE(lu.factorise());
      lu.solve(re.data(), is_complex ? im.data() : nullptr);
      for (std::size_t i = 0; i < n; ++i) {
        std::complex<double> rest = b[i];
        double size = std::abs(b[i]);
        for (std::size_t j = 0; j < n; ++j) {
          const std::complex<double> term =
              a[i * n + j] * std::complex(re[j], is_complex ? im[j] : 0);
          rest -= term;
          size += std::abs(term);
        }
        // Some tens of roundings of terms, which pivoting lets grow a little.
        EXPECT_LE(std::abs(rest), 1e-14 * size * (diagonal > 0 ? 1 : 10)) << width << ' ' << n;
      }
    }
}

TEST(BandedLu, SolvesWithAndWithoutExchangesOfRows) {
  for (const double diagonal : {10.0, 0.0}) {
    expect_bands_solved<false>(diagonal);
    expect_bands_solved<true>(diagonal);
  }
}

}  // namespace
}  // namespace odeum::banded_lu_test
