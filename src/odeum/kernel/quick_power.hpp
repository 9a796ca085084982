// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

// Timed units round these in their own way (CMakeLists.txt), so that there they are other
// functions.
#ifndef ODEUM_ROUNDING
#define ODEUM_ROUNDING each_operation
#endif
namespace odeum {
inline namespace ODEUM_ROUNDING {

/// log2 x to 5e-6, for positive normal x.
inline double quick_log2(double x) {
  // x = 2^n (1 + u) with 1 + u in [1/sqrt 2, sqrt 2), and a polynomial without a division.
  constexpr auto lowest = std::bit_cast<std::int64_t>(0.70710678118654757);
  const auto bits = std::bit_cast<std::int64_t>(x);
  const std::int64_t n = (bits - lowest) >> 52;
  const double u = std::bit_cast<double>(bits - (n << 52)) - 1, u2 = u * u;
  const double low = 1.442700440013496 - 0.7211957523938721 * u;
  const double middle = 0.47992557347074644 - 0.3669257709573897 * u;
  const double high = 0.316898187156837 - 0.20228926373030143 * u;
  return static_cast<double>(n) + u * (low + u2 * (middle + u2 * high));
}

/// 2^x to a relative 4e-6; |x| above 1000 counts as 1000.
inline double quick_exp2(double x) {
  // x = n + f, |f| <= 1/2: the sum with 1.5 2^52 has n in its lowest bits.
  constexpr double shift = 0x1.8p52;
  const double bounded = std::clamp(x, -1000.0, 1000.0);
  const double shifted = bounded + shift, f = bounded - (shifted - shift), f2 = f * f;
  const double low = 0.9999999999999998 + 0.693121045203427 * f;
  const double high = 0.24022349038020335 + 0.055921975842256264 * f + 0.009666368515387469 * f2;
  const auto exponent = std::bit_cast<std::uint64_t>(shifted) << 52;
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(low + f2 * high) + exponent);
}

/// x^p to a relative 1e-5, for positive normal x and |p| <= 2: enough for a step control, whose
/// factors are estimates to some per cent. std::pow costs as much as a stage of a small problem.
inline double quick_power(double x, double p) { return quick_exp2(p * quick_log2(x)); }

/// x^p for one p, |p| <= 1/2, to a relative 2e-4 where p = -1/2 and 1e-5 from -1/8 on: a table for
/// the power of two in x, a polynomial for the rest. A third of the latency of quick_power. Outside
/// of [2^-67, 2^64) only the power of two counts, as that of the nearer end.
class FixedPower {
 public:
  explicit FixedPower(double p) {
    const double down = std::exp2(-p), up = std::exp2(p);
    powers_[zero] = 1;
    for (std::size_t i = zero; i > 0; --i) powers_[i - 1] = powers_[i] * down;
    for (std::size_t i = zero; i + 1 < powers_.size(); ++i) powers_[i + 1] = powers_[i] * up;
    // Newton's interpolation of m^p at Chebyshev's points of [1, 2], in powers of m - 3/2.
    constexpr std::array<double, 5> nodes{-0.47552825814757677, -0.29389262614623657, 0,
                                          0.29389262614623657, 0.47552825814757677};
    std::array<double, 5> differences{};
    for (std::size_t i = 0; i < 5; ++i) differences[i] = std::pow(1.5 + nodes[i], p);
    for (std::size_t k = 1; k < 5; ++k)
      for (std::size_t i = 4; i >= k; --i)
        differences[i] = (differences[i] - differences[i - 1]) / (nodes[i] - nodes[i - k]);
    for (std::size_t k = 5; k-- > 0;) {
      for (std::size_t i = 4; i > 0; --i) series_[i] = series_[i - 1] - nodes[k] * series_[i];
      series_[0] = differences[k] - nodes[k] * series_[0];
    }
  }

  double operator()(double x) const {
    constexpr std::uint64_t mantissa = (std::uint64_t{1} << 52) - 1;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto exponent = static_cast<std::int64_t>(bits >> 52) - (1023 - zero);
    const auto at = std::clamp<std::int64_t>(exponent, 0, powers_.size() - 1);
    const auto& c = series_;
    const double m = std::bit_cast<double>((bits & mantissa) | std::uint64_t{1023} << 52) - 1.5;
    const double m2 = m * m;
    return ((c[0] + c[1] * m) + m2 * ((c[2] + c[3] * m) + m2 * c[4])) *
           powers_[static_cast<std::size_t>(at)];
  }

 private:
  static constexpr std::size_t zero = 67;  ///< the place of 2^0
  std::array<double, 131> powers_{};
  std::array<double, 5> series_{};
};

/// x^(-percent / 100 / (2 k)), as of controllers of an estimate of order k - 1, which take a
/// square; made at first use, since making one costs as much as several steps of a small problem.
template <int percent>
const FixedPower& power_of_square(int k) {
  static const auto all = []<std::size_t... J>(std::index_sequence<J...>) {
    return std::array{FixedPower(-0.005 * percent / static_cast<double>(J + 1))...};
  }
  (std::make_index_sequence<32>{});
  return all.at(static_cast<std::size_t>(k - 1));
}

/// x^n, n >= 0 and small.
constexpr double power(double x, int n) {
  double product = 1;
  for (int i = 0; i < n; ++i) product *= x;
  return product;
}

}  // namespace ODEUM_ROUNDING
}  // namespace odeum
