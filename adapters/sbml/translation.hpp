// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "odeum/formula/statement_text.hpp"
#include "sbml/math.hpp"

namespace odeum::adapters::sbml {

/// What cannot be translated, and the element that has it.
class ElementError : public std::runtime_error {
 public:
  ElementError(const SBase& element, const std::string& what)
      : std::runtime_error(what), line_(element.getLine()), column_(element.getColumn()) {}
  unsigned line() const { return line_; }
  unsigned column() const { return column_; }

 private:
  unsigned line_, column_;
};

/// A quantity with an id of the model: what its symbol stands for in expressions.
struct Quantity {
  enum class Kind { compartment, species, parameter, reference, reaction };
  Kind kind;
  std::string name;  ///< in the text
  const SBase* element;
  const ASTNode *assigned = nullptr, *rated = nullptr, *initial = nullptr;
  bool is_reset = false;  ///< by an event
};

/// The sections of a text that says what a model says.
class Translation {
 public:
  explicit Translation(const Model& model)
      : model_(model),
        text_(model.isSetName() ? model.getName()
              : model.isSetId() ? model.getId()
                                : "a model in SBML") {}
  /// Throws ElementError.
  std::string text(double end);

 private:
  using Kind = Quantity::Kind;
  /// Reads the model's elements: quantities.cpp.
  void collect();
  void add(Kind kind, const std::string& id, const SBase& element);
  void collect_rules();
  void collect_events();

  const Quantity& quantity(const std::string& id) const;
  /// The volume of a species' compartment changes.
  bool volume_changes(const Species& species) const;
  /// The symbol of a species is its amount.
  bool is_amount(const Species& species) const;
  bool is_changed_by_reactions(const Species& species) const;
  std::string volume(const Species& species, bool at_start);

  /// Expressions, as they run and of the start. `in`: its local parameters count.
  std::string expression(const ASTNode& node, const SBase& of, bool at_start,
                         const Reaction* in = nullptr, bool as_condition = false);
  std::string value(const std::string& id, bool at_start, const Reaction* in);
  std::string start_of(const std::string& id);
  std::string start_without_rules(const Quantity& q, const std::string& id);
  /// The amount at the start of a species whose symbol is a concentration.
  std::string start_amount(const std::string& id, const Species& species);
  std::string rate_of(const std::string& id, bool at_start);
  /// What reactions make of a species in unit time, as an amount.
  std::string made(const Species& species, bool at_start);
  std::string own_stoichiometry(const SpeciesReference& reference, bool at_start);
  std::string stoichiometry(const SpeciesReference& reference, bool at_start);
  std::string law(const Reaction& reaction, bool at_start);

  void write_species(const std::string& id, const Quantity& q);
  void write_measures(const std::string& id, const Quantity& q);
  void write_other(const std::string& id, const Quantity& q);
  void write_locals(const Reaction& reaction);
  /// Events: events.cpp.
  void write_event(const Event& event, int place);
  /// The state that an assignment to a quantity sets, and its value.
  std::pair<std::string, std::string> reset(const Event& event, const EventAssignment& assignment);
  void add_state(const std::string& name, const std::string& start, const std::string& equation);

  const Model& model_;
  formula::StatementText text_;
  std::map<std::string, Quantity> quantities_;
  std::vector<std::string> order_;                                    ///< of ids
  std::map<std::string, std::map<std::string, std::string>> locals_;  ///< by reaction: names by id
  std::map<std::string, std::string> starts_, rates_;  ///< rates_: names of their definitions
  std::map<std::string, std::string> amounts_;  ///< by species: the state that has its amount
  std::set<std::string> in_start_;              ///< that are being found
};

}  // namespace odeum::adapters::sbml
