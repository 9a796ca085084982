// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/formula/problem.hpp"

namespace odeum::tests {

/// What is wrong with the text of a problem file named f, from its line on; empty: nothing.
inline std::string fault_of(const std::string& text, const formula::Overrides& overrides = {}) {
  try {
    formula::read_problem("f", text, overrides);
    return "";
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.starts_with("f:") ? what.substr(2) : "no place: " + what;
  }
}

/// A problem of one state x with that equation.
inline std::string with_equation(const std::string& equation) {
  return "states: {x: 1}\nequations:\n  x: " + equation + "\ntime: {end: 1}\n";
}

}  // namespace odeum::tests
