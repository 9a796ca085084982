// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum {

/// Cases that a user gave to this run of the program. They are added before a study begins, by one
/// thread. A late library (late.hpp) adds to all_cases(), which every command runs by default, and
/// enrols solvers; a given case is made once all_cases() and their solvers are known, and runs only
/// where it is named.
std::vector<const Case*> given_cases();
/// The case stays where it is until the program ends. Throws std::invalid_argument where one of
/// that id was given before.
const Case& add_given_case(Case c);

/// all_cases(), then those that were given.
inline std::vector<const Case*> known_cases() {
  std::vector<const Case*> cases;
  for (const Case& c : all_cases()) cases.push_back(&c);
  for (const Case* c : given_cases()) cases.push_back(c);
  return cases;
}

}  // namespace odeum
