// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "odeum/input/yaml_tree.hpp"

namespace odeum::formula {

/// A problem file that is written for a model in another format.
class StatementText {
 public:
  explicit StatementText(std::string title) : title_(std::move(title)) {}

  /// The name, or one made of it that a text may give and nothing has yet; of the text from now on.
  std::string new_name(const std::string& wished);

  void parameter(const std::string& name, const std::string& value) {
    parameters_.emplace_back(name, value);
  }
  void definition(const std::string& name, const std::string& value) {
    definitions_.emplace_back(name, value);
  }
  void state(const std::string& name, const std::string& start) {
    states_.emplace_back(name, start);
  }
  void equation(const std::string& name, const std::string& rate) {
    equations_.emplace_back(name, rate);
  }
  void reaction(const std::string& species, const std::string& constant) {
    reactions_.emplace_back(species, constant);
  }
  /// A column, unless a state or an output before it has that name.
  void output(const std::string& column, const std::string& value) {
    outputs_.emplace_back(column, value);
  }
  /// Keys and values of an event, and the states that it sets.
  void event(const std::vector<std::pair<std::string, std::string>>& keys,
             const std::vector<std::pair<std::string, std::string>>& set) {
    events_.emplace_back(keys, set);
  }
  bool has_states() const { return !states_.empty(); }

  /// What refers to others of its section stands behind them. Throws std::invalid_argument where
  /// that cannot be, and names one of the cycle.
  std::string text(double end) const;

 private:
  using Entries = std::vector<std::pair<std::string, std::string>>;
  static std::string in_order(const Entries& all);

  std::string title_;
  std::set<std::string> names_;
  std::vector<std::pair<Entries, Entries>> events_;
  Entries parameters_, definitions_, states_, equations_, reactions_, outputs_;
};

}  // namespace odeum::formula
