// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/facts.hpp"

// lists/methods.inc is generated, and so is a unit for each method (odeum_generate_methods).
namespace odeum {

#define ODEUM_ITEM(method) void add_##method(std::vector<proof::MethodFacts>&);
#include "lists/methods.inc"
#undef ODEUM_ITEM

const std::vector<proof::MethodFacts>& proof::all_method_facts() {
  static const std::vector<MethodFacts> all = [] {
    std::vector<MethodFacts> list;
#define ODEUM_ITEM(method) add_##method(list);
#include "lists/methods.inc"
#undef ODEUM_ITEM
    return list;
  }();
  return all;
}

}  // namespace odeum
