// SPDX-License-Identifier: BSD-3-Clause
#include "support/late_cases.hpp"

#include <utility>

#include "odeum/contest/late.hpp"
#include "support/stage.hpp"

namespace odeum::cases {

std::vector<Case> late_cases() {
  std::vector<Case> all;
  for (const LateLibrary& library : late_libraries()) {
    if (!library.cases) continue;
    for (Case& c : library.cases()) {
      c.entrants = enroll(c.problem);
      if (library.finish) library.finish(c);
      all.push_back(std::move(c));
    }
  }
  return all;
}

}  // namespace odeum::cases
