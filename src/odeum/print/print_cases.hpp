// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace odeum::print {

struct Printed {
  std::string header;  ///< of the problem
  std::string unit;    ///< with the function `stem` that makes its cases
};

/// The C++ of a problem file with the key `cases`; CONTRIBUTING.md has what stands there. Throws
/// InputError.
Printed print_cases(const std::string& file, const std::string& text);

}  // namespace odeum::print
