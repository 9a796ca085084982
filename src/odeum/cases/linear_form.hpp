// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// A linear case of few unknowns as u' = A u + b, in 1 / (unit of t).
struct LinearForm {
  std::size_t size = 0;
  std::vector<double> a;                          ///< dense, by rows, constant
  std::vector<double> b;                          ///< at the start
  bool b_varies = false;                          ///< with t
  std::vector<std::complex<double>> eigenvalues;  ///< of A, conjugates and multiple ones too
  /// The solution of each component as an expression in t (in s = t - t0 where the case does not
  /// start at 0): a sum of products of powers, exponentials, sines and cosines, of 10 digits.
  /// Agrees with the matrix exponential to 1e-9 of the state's size up to the horizon; empty where
  /// none does, or where b varies.
  std::vector<std::string> solution;
};

inline constexpr std::size_t most_unknowns_shown = 8;

/// Nothing where the case is not linear with a constant A, or has more unknowns than that.
std::optional<LinearForm> linear_form(const Case& c);

/// A matrix for people: `[1 0; 0 1]`.
std::string text_of_matrix(const std::vector<double>& matrix, std::size_t columns);
/// Eigenvalues for people, a conjugate pair as one: `-1 +- 2i, -3 (twice)`.
std::string text_of_eigenvalues(std::vector<std::complex<double>> values);

/// What is known of it in words: a name of one word, and a text.
Facts facts_of(const LinearForm& form, const Case& c);

}  // namespace odeum::cases
