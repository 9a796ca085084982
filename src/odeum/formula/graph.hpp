// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <vector>

/// Expressions of a time and of states, as a graph in which equal subexpressions are one node.
namespace odeum::formula {

/// By the number of arguments: none to state, one to sign, two to max, three; arithmetic and
/// comparisons come before functions.
enum class Op : std::uint8_t {
  constant,
  time,
  state,
  negate,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sinh,
  cosh,
  tanh,
  exp,
  log,
  log10,
  sqrt,
  abs,
  sign,
  add,
  subtract,
  multiply,
  divide,
  less,
  less_equal,
  equal,
  power,
  atan2,
  min,
  max,
  choose  ///< of[0] != 0 ? of[1] : of[2]
};

using Id = std::uint32_t;
inline constexpr Id no_node = static_cast<Id>(-1);

struct Node {
  Op op = Op::constant;
  std::array<Id, 3> of{no_node, no_node, no_node};  ///< arguments; no_node where there is none
  std::uint32_t index = 0;                          ///< of a state
  long double value = 0;                            ///< of a constant
};

/// The value of an operation; comparisons give 1 or 0. Real is double or long double.
template <class Real>
Real apply(Op op, Real a, Real b, Real c);
extern template double apply(Op, double, double, double);
extern template long double apply(Op, long double, long double, long double);

/// A graph that only grows. The arguments of a node have smaller ids than the node, so that a walk
/// in the order of the ids meets arguments first. Constants are folded in extended precision; sums
/// and products with 0 and 1 vanish, as do powers with small whole and half exponents, which become
/// products, quotients and square roots. All else keeps the order in which it was written.
class Graph {
 public:
  Id constant(long double value);
  Id time() { return intern({.op = Op::time}); }
  Id state(std::uint32_t index) { return intern({.op = Op::state, .index = index}); }
  Id make(Op op, Id a, Id b = no_node, Id c = no_node);

  const Node& operator[](Id id) const { return nodes_[id]; }
  std::size_t size() const { return nodes_.size(); }
  bool is_constant(Id id) const { return nodes_[id].op == Op::constant; }
  bool is(Id id, long double value) const { return is_constant(id) && nodes_[id].value == value; }
  /// The derivative of a node by its argument number `argument`, the others held; no_node where it
  /// is zero or does not exist (of a condition).
  Id partial(Id node, std::size_t argument);
  /// The nodes on which some roots depend, themselves among them, in ascending order.
  std::vector<Id> needed(const std::vector<Id>& roots) const;

 private:
  struct Key {
    std::array<std::uint64_t, 4> words;
    bool operator==(const Key&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Key& key) const;
  };
  Id intern(Node node);
  Id simplified(Op op, Id a, Id b);
  Id simplified_sum(Op op, Id a, Id b);
  Id simplified_product(Op op, Id a, Id b);
  Id simplified_power(Id a, Id b);
  Id whole_power(Id base, unsigned exponent);

  std::vector<Node> nodes_;
  std::unordered_map<Key, Id, Hash> known_;
};

/// The number of arguments of an operation.
std::size_t arity(Op op);
/// Whether the result has kinks or jumps where its arguments are smooth.
bool has_kinks(Op op);

/// The derivatives of some roots by each state and by the time: for each root its nonzero entries,
/// by ascending number of the state; the time counts as state `states`. Throws std::length_error
/// where they are more than `most` in all nodes together.
struct Entry {
  std::uint32_t by = 0;
  Id value = no_node;
};
std::vector<std::vector<Entry>> gradients(Graph& graph, const std::vector<Id>& roots,
                                          std::uint32_t states, std::size_t most = 4'000'000);

}  // namespace odeum::formula
