// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string_view>

#include "odeum/formula/parser.hpp"

/// The index of a sum, sum(j, sin(x[j] - x[i])).
namespace odeum::formula {

/// Whether a sum's index may have this name: nothing else in the scope has it.
bool is_free_index(std::string_view name, const Scope& scope);

/// The array whose elements the index counts in the sum whose terms begin at `at`: the one, or one
/// of those of the same indices, that stands there with the index alone. Throws ExpressionError
/// where there is none, or where they have different indices.
const Array& counted_by(std::string_view index, std::string_view text, std::size_t at,
                        const Scope& scope);

}  // namespace odeum::formula
