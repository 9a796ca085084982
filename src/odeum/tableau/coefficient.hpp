// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gmpxx.h>

#include <stdexcept>
#include <string_view>

namespace odeum {

/// Bits of precision of irrational coefficients.
inline constexpr unsigned long coefficient_bits = 512;

/// A number read from a file: exact where it consists of fractions and decimals, to
/// `coefficient_bits` where it has a square root.
struct Coefficient {
  mpq_class exact;       ///< where `rational`
  mpf_class value;       ///< always
  bool rational = true;  ///< it has no irrational square root
  /// Bound on the error of the value: half a unit of the last digit of rounded decimals (15
  /// significant digits or more), propagated; 0: the text is exact.
  double uncertainty = 0;
};

/// Thrown for a text that is not a number; `what()` is a short phrase such as "a division by zero".
class CoefficientError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads `2/9`, `-3/4`, `0.25`, `1e-3`, `(2 - sqrt(2))/2`: sums, products and quotients of decimals
/// and square roots. Throws CoefficientError; nan, inf, numbers with a leading zero and decimal
/// commas are refused.
Coefficient parse_coefficient(std::string_view text);

}  // namespace odeum
