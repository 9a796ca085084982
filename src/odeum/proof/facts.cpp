// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/facts.hpp"

// lists/families.inc is generated, and so is a function for each family (odeum_generate_methods).
namespace odeum {

#define ODEUM_ITEM(family) void add_##family(std::vector<proof::MethodFacts>&);
#include "lists/families.inc"
#undef ODEUM_ITEM

const std::vector<proof::MethodFacts>& proof::all_method_facts() {
  static const std::vector<MethodFacts> all = [] {
    std::vector<MethodFacts> list;
#define ODEUM_ITEM(family) add_##family(list);
#include "lists/families.inc"
#undef ODEUM_ITEM
    return list;
  }();
  return all;
}

}  // namespace odeum
