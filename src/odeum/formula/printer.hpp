// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "odeum/formula/graph.hpp"

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
  std::string operation(Op op, const std::string& a, const std::string& b, const std::string& c,
                        const Type& type) const {
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
  std::string operation(const Node& node, const Type& type) const {
    const auto argument = [&](std::size_t k) {
      return node.of[k] == no_node ? std::string() : name(node.of[k], type);
    };
    return operation(node.op, argument(0), argument(1), argument(2), type);
  }

  /// Computes the nodes on which roots depend; `state` prints state number k.
  template <class StateText>
  void nodes(const std::vector<Id>& roots, const Type& type, StateText&& state) {
    for (const Id id : graph_.needed(roots)) {
      const Node& node = graph_[id];
      if (node.op == Op::constant) continue;
      const std::string value = node.op == Op::state  ? state(node.index)
                                : node.op == Op::time ? "t"
                                                      : operation(node, type);
      line("  const {} v{} = {};", type.name, id, value);
    }
  }

 private:
  static const char* function_name(Op op) {
    switch (op) {
      case Op::sin:
        return "sin";
      case Op::cos:
        return "cos";
      case Op::tan:
        return "tan";
      case Op::asin:
        return "asin";
      case Op::acos:
        return "acos";
      case Op::atan:
        return "atan";
      case Op::sinh:
        return "sinh";
      case Op::cosh:
        return "cosh";
      case Op::tanh:
        return "tanh";
      case Op::exp:
        return "exp";
      case Op::log:
        return "log";
      case Op::log10:
        return "log10";
      case Op::sqrt:
        return "sqrt";
      default:
        return "fabs";
    }
  }

  const Graph& graph_;
};

}  // namespace odeum::formula
