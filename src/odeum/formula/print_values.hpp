// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "odeum/formula/printer.hpp"

namespace odeum::formula {

/// A function of C that fills an array with values of nodes.
struct Function {
  std::string name;
  std::string arguments;    ///< between its parentheses, all of them
  std::string passed;       ///< their names
  std::string target;       ///< the name of the array
  std::size_t cleared = 0;  ///< so many of its elements are set to 0 before
  std::string first = "y",
              second = "";  ///< the arrays of the states up to `split` and from there on
  std::uint32_t split = static_cast<std::uint32_t>(-1);
};

/// `name`(const void* problem, t, y, f) in numbers of a type.
Function values_function(const std::string& name, const Type& type);

/// The function sets target[places[k]] to root number k. Many roots of one form are computed in
/// loops, so that the text, and with it the compiler's time, does not grow with a family of states;
/// the others in parts, since that time grows faster than the length of a function. What two parts
/// need is computed in both.
void print_values(Printer& out, const Function& function, const std::vector<Id>& roots,
                  const std::vector<std::uint32_t>& places, const Type& type);

}  // namespace odeum::formula
