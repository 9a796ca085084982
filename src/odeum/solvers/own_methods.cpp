// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/own_methods.hpp"

#include <algorithm>

// lists/methods.inc is generated, and so is a unit for each method (odeum_generate_methods); those
// on residuals are residual_methods.cpp.
namespace odeum {

#define ODEUM_ITEM(method) void add_##method(std::vector<Solver>&);
#include "lists/methods.inc"
#undef ODEUM_ITEM
void add_residual_methods(std::vector<Solver>&);

const std::vector<Solver>& own_methods() {
  static const std::vector<Solver> all = [] {
    std::vector<Solver> list;
#define ODEUM_ITEM(method) add_##method(list);
#include "lists/methods.inc"
#undef ODEUM_ITEM
    add_residual_methods(list);
    return list;
  }();
  return all;
}

const Solver* find_own_solver(std::string_view method) {
  const auto at = std::ranges::find(
      own_methods(), method, [](const Solver& own) -> std::string_view { return own.info.method; });
  return at == own_methods().end() ? nullptr : &*at;
}
const Solver& own_solver(std::string_view method) { return *find_own_solver(method); }

}  // namespace odeum
