// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "odeum/formula/graph.hpp"
#include "odeum/formula/table.hpp"

namespace odeum::formula {

/// A mistake in an expression; `at` counts bytes from its start.
class ExpressionError : public std::runtime_error {
 public:
  ExpressionError(std::size_t at, const std::string& what) : std::runtime_error(what), at_(at) {}
  std::size_t at() const { return at_; }

 private:
  std::size_t at_;
};

/// Indexed states u[first..last], and the values given for indices beyond.
struct Array {
  std::int64_t first = 1;
  std::vector<Id> elements;
  std::map<std::int64_t, Id> beyond;

  std::int64_t last() const { return first + static_cast<std::int64_t>(elements.size()) - 1; }
};

/// What names stand for.
struct Scope {
  std::map<std::string, Id, std::less<>> names;
  std::map<std::string, Array, std::less<>> arrays;
  /// Names that exist and cannot be used here: the reason, as the end of a sentence.
  std::map<std::string, std::string, std::less<>> refused;
  std::map<std::string, Table, std::less<>> tables;  ///< functions of one argument
  /// The times that a table has to have where it is one of the time.
  std::optional<std::pair<long double, long double>> span;
  std::optional<std::int64_t> index;  ///< the value of i
  std::size_t repeats = 1;            ///< of the expression: this one and those for larger i

  /// Whether a sum's index may have this name: nothing else has it.
  bool is_free_index(std::string_view name) const;
  /// The array whose elements an index counts in the sum whose terms begin at `at`: the one, or
  /// one of those of the same indices, that stands there with the index alone. Throws
  /// ExpressionError where there is none, or where they have different indices.
  const Array& counted_by(std::string_view counter, std::string_view text, std::size_t at) const;
};

inline constexpr std::size_t longest_expression = 100'000;  ///< in bytes
inline constexpr int deepest_nesting = 200;
inline constexpr std::size_t most_nodes = 1'000'000;   ///< of a graph
inline constexpr std::size_t most_terms = 10'000'000;  ///< of sums, in some seconds

/// The node of an expression: numbers, + - * / ^, parentheses, t, pi, e, functions, and
/// if(condition, a, b) and sums over an index. Throws ExpressionError where the text is not an
/// expression, for unknown names, for a constant part that is not finite, and beyond the limits
/// above.
Id parse_expression(std::string_view text, const Scope& scope, Graph& graph);

/// The same where a condition may stand too: 0 or 1.
Id parse_expression(std::string_view text, const Scope& scope, Graph& graph, bool& is_condition);

/// A whole number: an index. Throws as parse_expression, and where it is not a whole number.
std::int64_t parse_index(std::string_view text, const Scope& scope, Graph& graph);

}  // namespace odeum::formula
