// SPDX-License-Identifier: BSD-3-Clause
#include "support/late_cases.hpp"

#include <utility>

#include "odeum/contest/late.hpp"
#include "support/foreign_case.hpp"

namespace odeum::cases {

std::vector<Case> late_cases() {
  std::vector<Case> all;
  for (const LateLibrary& library : late_libraries()) {
    if (!library.problems) continue;
    for (foreign::Given& given : library.problems())
      all.push_back(foreign_case(std::move(given)).c);
  }
  return all;
}

}  // namespace odeum::cases
