// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>

#include "odeum/formula/reader.hpp"

namespace odeum::formula::reading {

/// The species of a reaction `A + 2 B -> C` or `A <-> B`, without its rate: names of `scope`, each
/// after a number, or an expression of `constants` in parentheses. Throws ExpressionError.
Reaction read_reaction(std::string_view text, const Scope& scope, const Scope& constants,
                       Graph& graph);

}  // namespace odeum::formula::reading
