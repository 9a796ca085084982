// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace odeum::build {

/// The program's object files by unit, and a hash of each unit's; see
/// scripts/cmake/HashUnits.cmake.
extern const std::vector<std::pair<std::string, std::string>> units;

}  // namespace odeum::build
