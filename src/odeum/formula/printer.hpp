// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "odeum/formula/analysis.hpp"

namespace odeum::formula {

/// A number type of C, what stands around the names of its functions, and the suffix of its
/// constants. `in_real` is the R of a template of C++, `in_lanes` a vector (lane_code.cpp).
struct Type {
  const char* name;
  const char* before;
  const char* after;
  const char* constant;
  bool lanes;
};
inline constexpr Type in_double{"double", "__builtin_", "", "", false},
    in_long_double{"long double", "__builtin_", "l", "L", false},
    in_real{"R", "std::", "", "", false}, in_lanes{"V", "lanes_", "", "", true};

inline std::string constant_text(long double value, const Type& type) {
  const std::string text = *type.constant ? fmt::format("{:a}L", value)
                                          : fmt::format("{:a}", static_cast<double>(value));
  if (type.lanes) return "all(" + text + ")";
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
    if (node.op != Op::constant) return fmt::format("v{}", id);
    if (node.index == 0) return constant_text(node.value, type);
    return numbered        ? fmt::format("{}[{}]", owner, node.index - 1)
           : names.empty() ? owner + graph_.definitions()[node.index - 1].name
                           : owner + names[node.index - 1];
  }
  static std::string operation(Op op, const std::string& a, const std::string& b,
                               const std::string& c, const Type& type) {
    const Operation& meaning = meaning_of(op);
    if (type.lanes && (op == Op::sign || op == Op::side))
      return fmt::format("lanes_{}({})", op == Op::sign ? "sign" : "side", a);
    const std::string call = fmt::format("{{3}}{}{{4}}({{0}}{})", meaning.name ? meaning.name : "",
                                         meaning.arguments > 1 ? ", {1}" : "");
    return fmt::format(fmt::runtime(meaning.c ? meaning.c : call), a, b, c, type.before,
                       type.after);
  }
  /// An operation on nodes.
  std::string operation(Op op, const std::array<Id, 3>& of, const Type& type) const {
    const auto argument = [&](std::size_t k) {
      return of[k] == no_node ? std::string() : name(of[k], type);
    };
    return operation(op, argument(0), argument(1), argument(2), type);
  }
  std::string owner;  ///< what constants with a name are members of, with the sign of access
  std::vector<std::string> names;  ///< those of the definitions in the text; empty: their own
  bool numbered = false;           ///< they are its elements, in the order of their definitions

 private:
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

/// A Jacobian by its rows as a dense one, row-major.
void print_jacobian(Printer& out, Function function, const std::vector<std::vector<Entry>>& rows,
                    const Type& type);

/// Computes the nodes on which roots depend.
void print_nodes(Printer& out, const Function& function, const std::vector<Id>& roots,
                 const Type& type);

/// `head` and the rest of a function that fills c, see Series.
void print_series(Printer& out, const std::string& head, const Problem& problem,
                  const SeriesPlan& plan);

/// The function sets target[places[k]] to root number k. Many roots of one form are computed in
/// loops, so that the text, and with it the compiler's time, does not grow with a family of states;
/// the others in parts, since that time grows faster than the length of a function. What two parts
/// need is computed in both.
void print_values(Printer& out, const Function& function, const std::vector<Id>& roots,
                  const std::vector<std::uint32_t>& places, const Type& type);

}  // namespace odeum::formula
