// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <bit>
#include <cstdint>

namespace odeum {

/// x^p to a relative 1e-5, for positive normal x with |p log2 x| < 1000: enough for a step control,
/// whose factors are estimates to some per cent. std::pow costs as much as a stage of a small
/// problem. Always inlined, as PredictiveControl is: timed units round it in their own way.
[[gnu::always_inline]] inline double quick_power(double x, double p) {
  // log2 of the mantissa, moved to [1/sqrt 2, sqrt 2), by the series of atanh.
  constexpr std::uint64_t mantissa = (std::uint64_t{1} << 52) - 1;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto m = std::bit_cast<double>((bits & mantissa) | (std::uint64_t{1023} << 52));
  auto exponent = static_cast<double>(static_cast<std::int64_t>(bits >> 52) - 1023);
  const bool upper = m > 1.4142135623730951;
  m = upper ? m / 2 : m;
  exponent += upper;
  const double s = (m - 1) / (m + 1), s2 = s * s;
  constexpr double two_over_ln2 = 2.8853900817779268;
  const double log2 = exponent + two_over_ln2 * s * (1 + s2 * (1. / 3 + s2 / 5));
  // 2^(n + f), |f| <= 1/2, by the exponential series.
  const double y = std::clamp(p * log2, -1000.0, 1000.0);
  const auto n = static_cast<std::int64_t>(y + (y < 0 ? -0.5 : 0.5));
  const double f = 0.6931471805599453 * (y - static_cast<double>(n));
  const double series = 1 + f * (1 + f * (1. / 2 + f * (1. / 6 + f * (1. / 24 + f / 120))));
  return series * std::bit_cast<double>(static_cast<std::uint64_t>(n + 1023) << 52);
}

/// x^n, n >= 0 and small.
constexpr double power(double x, int n) {
  double product = 1;
  for (int i = 0; i < n; ++i) product *= x;
  return product;
}

}  // namespace odeum
