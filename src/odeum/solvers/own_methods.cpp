// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/own_methods.hpp"

// lists/families.inc is generated, and so is a function for each family (odeum_generate_methods).
namespace odeum {

#define ODEUM_ITEM(family) void add_##family(std::vector<Solver>&);
#include "lists/families.inc"
#undef ODEUM_ITEM

const std::vector<Solver>& own_methods() {
  static const std::vector<Solver> all = [] {
    std::vector<Solver> list;
#define ODEUM_ITEM(family) add_##family(list);
#include "lists/families.inc"
#undef ODEUM_ITEM
    return list;
  }();
  return all;
}

}  // namespace odeum
