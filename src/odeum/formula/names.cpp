// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "odeum/input/yaml_tree.hpp"

namespace odeum::formula {

const std::map<std::string, Op, std::less<>>& functions() {
  static const std::map<std::string, Op, std::less<>> all = [] {
    std::map<std::string, Op, std::less<>> named;
    for (std::size_t op = leaves; op <= static_cast<std::size_t>(Op::choose); ++op)
      if (const char* const name = meaning_of(static_cast<Op>(op)).name)
        named.emplace(name, static_cast<Op>(op));
    return named;
  }();
  return all;
}

std::string fault_of_name(std::string_view name) {
  if (name.empty() || !begins_name(name[0]) || !std::ranges::all_of(name, continues_name)) {
    const std::string_view bare = name.substr(0, name.find_last_not_of('\'') + 1);
    if (bare.size() < name.size() && !bare.empty() && fault_of_name(bare).empty())
      return fmt::format("not a name; got {}, expected {}: an equation's entry is the derivative",
                         name, bare);
    return fmt::format("not a name; got {}, expected letters, digits and _, a letter first",
                       shown(name));
  }
  if (name.size() > 60)
    return fmt::format("a long name; got {} characters, expected 60 at most", name.size());
  const bool reserved = name == "t" || name == "pi" || name == "e" || functions().contains(name);
  if (reserved)
    return fmt::format("a name that is taken; got {}, which is {}, expected another", name,
                       name == "t"                  ? "the time"
                       : functions().contains(name) ? "a function"
                                                    : "a constant");
  return "";
}

}  // namespace odeum::formula
