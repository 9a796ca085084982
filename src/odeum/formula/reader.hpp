// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "odeum/formula/names.hpp"
#include "odeum/formula/parser.hpp"
#include "odeum/formula/problem.hpp"

/// The parts of the reader of problem files.
namespace odeum::formula::reading {

/// The text with the brackets of u[i] replaced by characters that YAML has no use for: in a mapping
/// in braces, a bracket would end the key or the expression.
std::string without_brackets(const std::string& text);
/// The text of a scalar or of an error, with its brackets.
std::string with_brackets(std::string text);

/// A key of the file with its value.
struct Item {
  std::string key;  ///< with its brackets
  Place key_place;
  const YamlNode* value;
};

/// A file while it is read: errors with their places, expressions.
class Source {
 public:
  Source(std::string file, const std::string& text);

  const YamlNode& root() const { return *root_; }
  [[noreturn]] void fail(Place place, const std::string& what) const;
  /// The items of a mapping (nothing counts as an empty one): keys are unique and scalars.
  std::vector<Item> items(const YamlNode& mapping, const std::string& key) const;
  /// The scalar of an item as an expression, a number or a whole number.
  Id expression(const Item& item, const std::string& in, const Scope& scope, Graph& graph) const;
  long double number(const YamlNode& value, const std::string& key, const Scope& scope,
                     Graph& graph) const;
  std::int64_t index(const Item& item, std::string_view text, const Scope& scope,
                     Graph& graph) const;

 private:
  std::string scalar(const YamlNode& value, const std::string& key) const;
  /// The place of byte `at` of a scalar's text, as far as the file's lines show it.
  Place place_in(const YamlNode& value, const std::string& text, std::size_t at) const;

  std::string file_;
  std::vector<std::string> lines_;
  std::shared_ptr<const YamlNode> root_;
};

/// A key `x`, `u[4]` or `u[1..100]`.
struct Key {
  std::string name;
  bool indexed = false;
  std::int64_t first = 0, last = 0;
};
Key read_key(const Source& source, const Item& item, const std::string& in, const Scope& constants,
             Graph& graph);

/// `text`, and the name that may have been meant.
std::string joined(const std::string& text, const std::string& near);

/// Reads a problem, section by section: reader.cpp, and reader_states.cpp for what is given by
/// state.
class Reader {
 public:
  Reader(const std::string& file, const std::string& text, const Overrides& overrides);
  Problem read();

 private:
  const Item* section(std::string_view key) const;  ///< null where the file has none
  std::vector<Item> items(const std::string& key) const;
  std::vector<Item> required_items(const std::string& key) const;
  void require_new(const Item& item, const std::string& in, const std::string& name);
  void read_parameters();
  void read_time();
  void read_stops(const YamlNode& list, double first, double last);
  void read_definitions(Scope& scope);

  void add_state(const Item& item, const std::string& name, const Scope& scope);
  void read_states();
  void add_states(Scope& scope);
  void read_boundaries(Scope& scope);
  /// Calls use(number of the state, its index where it has one) for each state that a key names.
  void for_each_state(const Item& item, const std::string& in,
                      const std::function<void(std::size_t, std::int64_t)>& use);
  /// A node for each state, no_node where none is given.
  std::vector<Id> read_by_state(const std::string& in, Scope scope, std::vector<Place>& places);
  void require_all(const std::string& in, const std::vector<Id>& nodes);
  void read_equations(const Scope& scope);
  /// Solves M v' = F for the equations of the states that have a mass: reader_mass.cpp.
  void read_mass(Scope& scope);
  void apply_mass(const std::vector<std::size_t>& at,
                  const std::vector<std::vector<long double>>& m,
                  const std::vector<std::vector<long double>>& inverse, Scope& scope);
  void read_exact();
  void read_invariants(const Scope& scope);
  void read_scale();
  void read_tolerance();

  Source source_;
  const Overrides& overrides_;
  Problem problem_;
  std::vector<Item> sections_;
  Scope constants_;                           ///< parameters
  std::map<std::string, std::string> names_;  ///< and the section that they are of
  std::map<std::string, Place> group_places_;
  std::map<std::string, std::int64_t> first_of_;  ///< of indexed states
};

}  // namespace odeum::formula::reading
