// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "odeum/cases/runtime_cases.hpp"
#include "odeum/solvers/case.hpp"

// lists/cases.inc is generated: the stems of the files in cases/.
namespace odeum {
namespace cases {

#define ODEUM_ITEM(stem) std::vector<Case> stem();
#include "lists/cases.inc"
#undef ODEUM_ITEM

}  // namespace cases

const std::vector<Case>& all_cases() {
  static const std::vector<Case> all = [] {
    std::vector<Case> list;
    const auto add = [&](std::vector<Case> more) {
      for (Case& c : more) list.push_back(std::move(c));
    };
#define ODEUM_ITEM(stem) add(cases::stem());
#include "lists/cases.inc"
#undef ODEUM_ITEM
    add(cases::runtime_cases());
    return list;
  }();
  return all;
}

}  // namespace odeum
