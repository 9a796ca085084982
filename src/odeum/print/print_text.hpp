// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

namespace odeum::print {

struct Printed {
  std::string header;  ///< the problem as a struct
  std::string unit;    ///< printed_<stem>(), see cases/printed_text.hpp
};

/// The problem of a file that is a built-in case, as code. Throws InputError for a problem that is
/// not printed: one with a mass matrix, or of more states than a dense Jacobian is printed for.
Printed print_text(const std::string& file, const std::string& text);

}  // namespace odeum::print
