// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/runtime_cases.hpp"

#include <utility>

#include "odeum/cases/foreign_case.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::cases {

std::vector<Case> runtime_cases() {
  std::vector<Case> all;
  for (const RuntimeLibrary& library : runtime_libraries()) {
    if (!library.problems) continue;
    for (foreign::ProblemCallbacks& given : library.problems())
      all.push_back(foreign_case(std::move(given)).c);
  }
  return all;
}

}  // namespace odeum::cases
