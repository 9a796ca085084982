// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/inlined.hpp"

// lists/inlined.inc is generated: the names of cases/inlined/lists.cmake.
namespace odeum {
namespace cases::inlined {

#define ODEUM_ITEM(name) void add_##name(const Case&, std::vector<Entrant>&);
#include "lists/inlined.inc"
#undef ODEUM_ITEM

}  // namespace cases::inlined

std::vector<Entrant> inlined_solvers([[maybe_unused]] const Case& c) {
  std::vector<Entrant> all;
#define ODEUM_ITEM(name) cases::inlined::add_##name(c, all);
#include "lists/inlined.inc"
#undef ODEUM_ITEM
  return all;
}

}  // namespace odeum
