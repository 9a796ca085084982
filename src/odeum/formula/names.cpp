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
    named.emplace("ceil", Op::floor);
    named.emplace("mod", Op::floor);
    return named;
  }();
  return all;
}

std::string_view known_as(std::string_view name) {
  static const std::map<std::string_view, std::string_view> all{
      {"ln", "log"},
      {"log2", "log(x)/log(2)"},
      {"pow", "x^y"},
      {"power", "x^y"},
      {"fabs", "abs"},
      {"sgn", "sign"},
      {"signum", "sign"},
      {"arcsin", "asin"},
      {"arccos", "acos"},
      {"arctan", "atan"},
      {"ceiling", "ceil"},
      {"round", "floor(x + 0.5)"},
      {"trunc", "sign(x)*floor(abs(x))"},
      {"rem", "mod(a, b)"},
      {"fmod", "mod(a, b)"},
      {"modulo", "mod(a, b)"},
      {"cbrt", "sign(x)*abs(x)^(1/3)"},
      {"square", "x^2"},
      {"heaviside", "if(x >= 0, 1, 0)"},
      {"Heaviside", "if(x >= 0, 1, 0)"},
      {"step", "if(x >= 0, 1, 0)"},
      {"piecewise", "if(condition, a, b)"},
      {"Piecewise", "if(condition, a, b)"},
      {"ifelse", "if(condition, a, b)"},
      {"where", "if(condition, a, b)"},
      {"and", "condition and condition"},
      {"or", "condition or condition"},
      {"xor", "a != b of two conditions as if(a, 1, 0) != if(b, 1, 0)"},
      {"fmin", "min"},
      {"fmax", "max"},
      {"sec", "1/cos(x)"},
      {"csc", "1/sin(x)"},
      {"cot", "1/tan(x)"},
      {"sech", "1/cosh(x)"},
      {"coth", "1/tanh(x)"}};
  const auto found = all.find(name);
  return found == all.end() ? std::string_view() : found->second;
}

bool is_word_of_conditions(std::string_view name) {
  return name == "and" || name == "or" || name == "not";
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
  const bool is_word = is_word_of_conditions(name), is_function = functions().contains(name);
  if (is_word || is_function || name == "t" || name == "pi" || name == "e")
    return fmt::format("a name that is taken; got {}, which is {}, expected another", name,
                       name == "t"   ? "the time"
                       : is_word     ? "a word of conditions"
                       : is_function ? "a function"
                                     : "a constant");
  return "";
}

}  // namespace odeum::formula
