// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/contest/case.hpp"

namespace odeum {

/// Adds a case that a user gave to this run of the program, before a study begins and by one
/// thread. A late library (late.hpp) adds to all_cases(), which every command runs by default, and
/// enrols solvers; a given case is made once all_cases() and their solvers are known, and runs only
/// where it is named. The case stays where it is until the program ends. Throws
/// std::invalid_argument where one of that id was given before.
const Case& add_given_case(Case c);

/// all_cases(), then those that were given.
std::vector<const Case*> known_cases();

}  // namespace odeum
