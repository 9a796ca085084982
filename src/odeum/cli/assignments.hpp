// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace odeum::cli {

/// The values of an option `NAME=NUMBER` that may be given several times (`option` is its name in
/// errors), in their order. Throws UsageError for what is not of that form, a number that is not
/// finite, and a name that is given twice.
std::vector<std::pair<std::string, double>> parse_assignments(
    const std::string& option, const std::vector<std::string>& texts);

}  // namespace odeum::cli
