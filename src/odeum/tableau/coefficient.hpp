// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gmpxx.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace odeum {

/// The bits that irrational coefficients are computed with.
inline constexpr unsigned long coefficient_bits = 512;

/// A number that a person wrote: exact where it is made of fractions and decimals, and to
/// `coefficient_bits` where a square root is in it.
struct Coefficient {
  mpq_class exact;       ///< where `rational`
  mpf_class value;       ///< always
  bool rational = true;  ///< no irrational square root is in it
  /// How far the true value may be off: half a unit of the last digit of decimals that were cut
  /// off (15 significant digits or more), carried through; 0: the text is the number.
  double uncertainty = 0;
};

/// What a text that is no number comes to; `what()` says what is wrong in a few words.
class CoefficientError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Reads `2/9`, `-3/4`, `0.25`, `1e-3`, `(2 - sqrt(2))/2`: sums, products and quotients of decimals
/// and square roots. Throws CoefficientError; nan, inf, octal-looking numbers and decimal commas
/// are no numbers here.
Coefficient parse_coefficient(std::string_view text);

}  // namespace odeum
