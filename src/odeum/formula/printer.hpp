// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "odeum/formula/names.hpp"

namespace odeum::formula {

/// A number type of C, the suffix of its functions and of its constants.
struct Type {
  const char* name;
  const char* function;
  const char* constant;
};
inline constexpr Type in_double{"double", "", ""}, in_long_double{"long double", "l", "L"};

inline std::string constant_text(long double value, const Type& type) {
  const std::string text = *type.constant ? fmt::format("{:a}L", value)
                                          : fmt::format("{:a}", static_cast<double>(value));
  return std::signbit(value) ? "(" + text + ")" : text;
}

/// 0, 1, ..., count - 1
inline std::vector<std::uint32_t> in_order(std::size_t count) {
  std::vector<std::uint32_t> places(count);
  std::iota(places.begin(), places.end(), 0U);
  return places;
}

/// Writes operations of a graph as C.
class Printer {
 public:
  explicit Printer(const Graph& graph) : graph_(graph) {}
  const Graph& graph() const { return graph_; }
  std::string text;

  template <class... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
    text += '\n';
  }

  /// What stands for a node in an expression.
  std::string name(Id id, const Type& type) const {
    const Node& node = graph_[id];
    return node.op == Op::constant ? constant_text(node.value, type) : fmt::format("v{}", id);
  }
  static std::string operation(Op op, const std::string& a, const std::string& b,
                               const std::string& c, const Type& type) {
    const char* const l = type.function;
    switch (op) {
      case Op::add:
        return fmt::format("{} + {}", a, b);
      case Op::subtract:
        return fmt::format("{} - {}", a, b);
      case Op::multiply:
        return fmt::format("{} * {}", a, b);
      case Op::divide:
        return fmt::format("{} / {}", a, b);
      case Op::negate:
        return fmt::format("-{}", a);
      case Op::less:
        return fmt::format("{} < {}", a, b);
      case Op::less_equal:
        return fmt::format("{} <= {}", a, b);
      case Op::equal:
        return fmt::format("{} == {}", a, b);
      case Op::choose:
        return fmt::format("{} != 0 ? {} : {}", a, b, c);
      case Op::min:
        return fmt::format("{1} < {0} ? {1} : {0}", a, b);
      case Op::max:
        return fmt::format("{0} < {1} ? {1} : {0}", a, b);
      case Op::sign:
        return fmt::format("({0} > 0) - ({0} < 0) + 0 * {0}", a);
      case Op::power:
        return fmt::format("__builtin_pow{}({}, {})", l, a, b);
      case Op::atan2:
        return fmt::format("__builtin_atan2{}({}, {})", l, a, b);
      default:
        return fmt::format("__builtin_{}{}({})", function_name(op), l, a);
    }
  }

 private:
  /// The name in C of a function.
  static std::string function_name(Op op) {
    if (op == Op::abs) return "fabs";
    return std::find_if(functions().begin(), functions().end(),
                        [op](const auto& known) { return known.second == op; })
        ->first;
  }

  const Graph& graph_;
};

/// A function of C that fills an array with values of nodes.
struct Function {
  std::string name;
  std::string arguments;    ///< between its parentheses, all of them
  std::string passed;       ///< their names
  std::string target;       ///< the name of the array
  std::size_t cleared = 0;  ///< so many of its elements are set to 0 before
  std::string first = "y",
              second = {};  ///< the arrays of the states up to `split` and from there on
  std::uint32_t split = static_cast<std::uint32_t>(-1);
};

/// `name`(const void* problem, t, y, f) in numbers of a type.
Function values_function(const std::string& name, const Type& type);

/// The function sets target[places[k]] to root number k. Many roots of one form are computed in
/// loops, so that the text, and with it the compiler's time, does not grow with a family of states;
/// the others in parts, since that time grows faster than the length of a function. What two parts
/// need is computed in both.
void print_values(Printer& out, const Function& function, const std::vector<Id>& roots,
                  const std::vector<std::uint32_t>& places, const Type& type);

}  // namespace odeum::formula
