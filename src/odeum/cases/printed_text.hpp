// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// The problem of a built-in text as compiled code: a unit that print/print_text.hpp prints.
struct PrintedText {
  std::vector<std::string> parameters;
  /// Sets the problem of a case that has its t0 and y0, with these values of the parameters, and
  /// all invariants that the text has.
  void (*put)(const double* values, Case& c);
  std::string code;  ///< the key of formula::code_of_problem
};

/// What was printed of a built-in text when Odeum was built; null where there is none of that stem.
const PrintedText* printed_of(std::string_view stem);
/// The one of which the same code was printed as would be of a text with this key.
const PrintedText* printed_with(std::string_view code);

}  // namespace odeum::cases
