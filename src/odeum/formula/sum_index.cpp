// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "odeum/formula/names.hpp"
#include "odeum/formula/parser.hpp"

namespace odeum::formula {

bool Scope::is_free_index(std::string_view name) const {
  return fault_of_name(name).empty() && !(name == "i" && index) && !names.contains(name) &&
         !arrays.contains(name);
}

const Array& Scope::counted_by(std::string_view counter, std::string_view text,
                               std::size_t at) const {
  const Array* found = nullptr;
  const std::string element = fmt::format("[{}]", counter);
  int open = 1;
  for (std::size_t k = at; k < text.size() && open > 0; ++k) {
    open += (text[k] == '(') - (text[k] == ')');
    if (!text.substr(k).starts_with(element)) continue;
    std::size_t name = k;
    while (name > at && continues_name(text[name - 1])) --name;
    const auto array = arrays.find(text.substr(name, k - name));
    if (array == arrays.end()) continue;
    const Array& other = array->second;
    if (found && (found->first != other.first || found->last() != other.last()))
      throw ExpressionError(name,
                            fmt::format("a sum over arrays of different indices; got {} to "
                                        "{} and {} to {}, expected the same",
                                        found->first, found->last(), other.first, other.last()));
    found = &other;
  }
  if (!found)
    throw ExpressionError(at, fmt::format("a sum over no array; got no state with the index {0} "
                                          "alone, expected one: x[{0}]",
                                          counter));
  return *found;
}

}  // namespace odeum::formula
