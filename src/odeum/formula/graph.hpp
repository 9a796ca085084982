// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "odeum/formula/operations.hpp"

/// Expressions of a time and of states, as a graph in which equal subexpressions are one node.
namespace odeum::formula {

using Id = std::uint32_t;
inline constexpr Id no_node = static_cast<Id>(-1);

struct Node {
  Op op = Op::constant;
  std::array<Id, 3> of{no_node, no_node, no_node};  ///< arguments; no_node where there is none
  /// The number of a state; of a constant with a name the number of its definition, from 1; else 0.
  std::uint32_t index = 0;
  long double value = 0;  ///< of a constant
};

/// A constant that has a name, for code that is to be printed: a parameter, or what an operation
/// makes of such.
struct Definition {
  std::string name;
  Id id = no_node;       ///< its node
  Op op = Op::constant;  ///< constant: a parameter
  std::array<Id, 3> of{no_node, no_node, no_node};
};

/// A graph that only grows. The arguments of a node have smaller ids than the node, so that a walk
/// in the order of the ids meets arguments first. Constants are folded in extended precision; sums
/// and products with 0 and 1 vanish, as do powers with small whole and half exponents, which become
/// products, quotients and square roots. All else keeps the order in which it was written. An
/// operation on constants of which one has a name gives a constant with a name.
class Graph {
 public:
  Id constant(long double value);
  /// A parameter that keeps its name.
  Id named(long double value, const std::string& name);
  Id time() { return intern({.op = Op::time}); }
  Id state(std::uint32_t index) { return intern({.op = Op::state, .index = index}); }
  Id make(Op op, Id a, Id b = no_node, Id c = no_node);

  const Node& operator[](Id id) const { return nodes_[id]; }
  std::size_t size() const { return nodes_.size(); }
  /// How many terms of sums over an index are read into it, `more` of them now.
  std::size_t count_terms(std::size_t more) { return terms_ += more; }
  bool is_constant(Id id) const { return nodes_[id].op == Op::constant; }
  bool is_number(Id id) const { return is_constant(id) && nodes_[id].index == 0; }
  bool is(Id id, long double value) const { return is_number(id) && nodes_[id].value == value; }
  /// The definitions in their order: one needs only what stands before it.
  const std::vector<Definition>& definitions() const { return definitions_; }
  /// The derivative of a node by its argument number `argument`, the others held, by the table of
  /// operations.cpp; no_node where it has none.
  Id partial(Id node, std::size_t argument);
  /// The base and the exponent of a power with a half exponent above 1; no_node: it is none.
  std::pair<Id, long double> half_power(Id node) const {
    const auto found = half_powers_.find(node);
    return found == half_powers_.end() ? std::pair{no_node, 0.0L} : found->second;
  }
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
  static Key key_of(const Node& node);
  Id intern(Node node);
  /// A constant with a name: the operation of `node`, all of whose arguments are constants.
  Id define(const Node& node, long double value);
  long double folded(Op op, Id a, Id b, Id c) const;
  Id simplified(Op op, Id a, Id b);
  Id simplified_sum(Op op, Id a, Id b);
  Id simplified_product(Op op, Id a, Id b);
  Id simplified_power(Id a, Id b);
  Id whole_power(Id base, unsigned exponent);

  std::vector<Node> nodes_;
  std::size_t terms_ = 0;
  std::vector<Definition> definitions_;
  std::unordered_map<Key, Id, Hash> known_;
  std::unordered_map<Id, std::pair<Id, long double>> half_powers_;
};

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
