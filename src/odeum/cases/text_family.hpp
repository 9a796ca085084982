// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "odeum/formula/problem.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// What Case::family is of the case `id` of a problem file, whose code is compiled once with the
/// parameters as variables. There is none where no compiler is, and where values move the start,
/// the end or the number of states, or masses.
std::function<std::optional<Family>(const std::vector<std::vector<double>>& samples)> text_family(
    const std::string& file, const std::string& text, const std::string& id,
    const formula::Overrides& set);

}  // namespace odeum::cases
