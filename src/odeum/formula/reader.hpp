// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "odeum/formula/names.hpp"
#include "odeum/formula/parser.hpp"
#include "odeum/formula/problem.hpp"
#include "odeum/formula/reduction.hpp"
#include "odeum/formula/stoichiometry.hpp"
#include "odeum/input/mapping.hpp"

/// The parts of the reader of problem files.
namespace odeum::formula::reading {

using Item = input::Entry;

/// A file while it is read: its mappings, errors with their places.
class Source {
 public:
  Source(const std::string& file, const std::string& text);

  const YamlNode& root() const { return *root_; }
  /// The items of a mapping (nothing counts as an empty one); of known keys alone, if any.
  std::vector<Item> items(const YamlNode& mapping, const std::string& path,
                          input::Keys known = {}) const {
    return input::Value(reading_, mapping, path).entries(known);
  }

 protected:
  template <class... Values>
  [[noreturn]] void fail(Place place, fmt::format_string<Values...> what,
                         Values&&... values) const {
    throw InputError(reading_.file, place, fmt::format(what, std::forward<Values>(values)...));
  }
  std::string scalar(const YamlNode& value, const std::string& key) const;
  /// The place of byte `at` of a scalar's text, as far as the file's lines show it.
  Place place_in(const YamlNode& value, const std::string& text, std::size_t at) const;

 private:
  std::shared_ptr<const YamlNode> root_;
  mutable input::Reading reading_;  // it collects warnings, of which problems have none
  std::vector<std::string> lines_;
};

/// A key `x`, `u[4]` or `u[1..100]`.
struct Key {
  std::string name;
  bool indexed = false;
  std::int64_t first = 0, last = 0;
};

/// A species that a reaction needs or makes: a state, or what no reaction changes.
struct Participant {
  Id species = no_node, coefficient = no_node;
};

inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1);  ///< no compartment

/// `A + 2 B -> C: k`, with its rate by the volume of one compartment.
struct Reaction {
  std::string text;
  Place place;
  std::vector<Participant> left, right;
  bool is_reversible = false;
  Id rate = no_node;
  std::size_t in = nowhere;
  bool between = false;  ///< species are in other compartments, too
};

struct Compartment {
  std::string name;
  Id volume;
  const YamlNode* species;
};

/// The terms that reactions add to the equations, by state, the places of the first ones (line 0:
/// none), and the amounts that each reaction makes.
struct Balance {
  std::vector<std::vector<Id>> gains, losses;
  std::vector<Place> place;
  std::vector<Weights> made;
};

/// Reads a problem, section by section: reader.cpp, and reader_states.cpp for what is given by
/// state.
class Reader : Source {
 public:
  Reader(const std::string& file, const std::string& text, const Overrides& overrides,
         Parameters kind);
  Problem read();

 private:
  /// The scalar of an item as an expression; a constant one as a number, a whole number.
  /// With `is_condition` it may be a condition, which that tells.
  Id expression(const Item& item, const std::string& in, const Scope& scope,
                bool* is_condition = nullptr);
  Id constant(const YamlNode& value, const std::string& key);
  long double number(const YamlNode& value, const std::string& key) {
    return problem_.graph[constant(value, key)].value;
  }
  std::int64_t index(const Item& item, std::string_view text);
  Key read_key(const Item& item, const std::string& in);

  /// Null where the file has none.
  const Item* section(std::string_view key) const { return input::entry_of(sections_, key); }
  using Source::items;
  std::vector<Item> items(const std::string& key) const;
  std::vector<Item> required_items(const std::string& key) const;
  void require_new(const Item& item, const std::string& in, const std::string& name);
  void read_parameters();
  void read_time();
  void read_stops(const YamlNode& list, double first, double last);
  void read_definitions(Scope& scope);
  /// Functions that are given by values, and quantities that the time alone decides:
  /// reader_tables.cpp.
  void read_tables();
  Table read_table(const YamlNode& node, const std::string& path);
  void read_points(const YamlNode& list, const std::string& path, Table& table);
  void read_inputs(Scope& scope);

  void add_state(const Item& item, const std::string& name);
  /// A state that is the rate of another one, in residuals of higher order.
  void require_rate(const Item& item, const std::string& of);
  void read_states();
  void add_states(Scope& scope);
  void read_boundaries(Scope& scope);
  /// A node for each state, no_node where none is given, and its place.
  std::vector<Id> read_by_state(const std::string& in, Scope scope, std::vector<Place>& places);
  void require_all(const std::string& in, const std::vector<Id>& nodes);
  void read_equations(const Scope& scope);
  /// Reactions, which add terms to the equations: reader_reactions.cpp.
  void read_compartments();
  void place_species(const Scope& scope);
  std::vector<std::size_t> compartments_of(const std::vector<Participant>& side) const;
  void find_compartment(Reaction& reaction, const Item* given) const;
  Id mass_action(Id constant, const std::vector<Participant>& side);
  void read_rate(Reaction& reaction, const YamlNode& value, const Scope& scope);
  std::vector<Reaction> reactions(const Scope& scope);
  void require_finite_rates(const std::vector<Reaction>& reactions) const;
  void add_reaction(const Reaction& reaction, Balance& balance);
  void read_reactions(const Scope& scope);
  void add_conserved_sums(const std::vector<Weights>& made);
  /// Which terms of the equations additive methods take implicitly: reader_implicit.cpp.
  void read_implicit(const Scope& scope);
  std::vector<Id> implicit_by_name(const YamlNode& list, const Scope& scope);
  /// Solves M v' = F for the equations of the states that have a mass: reader_mass.cpp.
  void read_mass(Scope& scope);
  void apply_mass(const std::vector<std::size_t>& at,
                  const std::vector<std::vector<long double>>& m,
                  const std::vector<std::vector<long double>>& inverse, Scope& scope);
  /// Solves residuals, or equations with constraints, for the rates of all states:
  /// reader_residuals.cpp, and reader_constraints.cpp for what follows from the reduction.
  void read_residuals(const Scope& scope);
  bool is_implicit() const { return section("residuals") || section("constraints"); }
  std::vector<Id> residuals_of(const Scope& all);
  std::vector<Id> equations_and_constraints(const Scope& scope);
  void read_residual_list(const char* in, const char* one, const Scope& scope,
                          std::vector<Id>& residuals);
  void add_rates_as_states(std::vector<Id>& residuals);
  void require_determined(const std::vector<Id>& residuals) const;
  void find_start(const std::vector<Constraint>& constraints);
  void require_constraints(const std::vector<Constraint>& constraints);
  void require_rates();
  void note_constraint(const Reduction& reduction, const Constraint& constraint);
  void note_residuals(const Reduction& reduction);
  void find_jumps();
  /// The largest magnitude of the constraints, and of hidden ones, as outputs.
  void add_drift();
  /// `residual 2` or `residuals 1, 2 together`; of a hidden one how it follows.
  std::string name_of(const Constraint& constraint) const;
  Place place_of_residual(std::size_t residual) const;
  /// What happens at times, or where expressions cross zero: reader_events.cpp.
  void read_events(const Scope& scope);
  Event read_event(const YamlNode& node, std::size_t place, const Scope& scope);
  void read_when(const std::vector<Item>& all, const std::string& path, const Scope& scope,
                 Event& event);
  void read_times(const std::vector<Item>& all, const std::string& path, Event& event);
  void read_way(const std::vector<Item>& all, const std::string& path, const Scope& scope,
                Event& event);
  bool is_true(const std::vector<Item>& all, const std::string& path, std::string_view key,
               bool usual) const;
  void read_resets(const Item& set, const std::string& path, const Scope& scope, Event& event);
  void require_order() const;
  void read_exact();
  void read_invariants(const Scope& scope);
  /// Quantities for columns of their own: a mapping, or a list of definitions.
  void read_outputs(const Scope& scope);
  void read_scale();
  void read_tolerance();

  /// Throws InputError where an equation is not finite at the start, or an invariant changes there.
  void require_start();
  /// Throws InputError where `exact` does not fulfil the initial values, or the equations at times
  /// from the start to the end.
  void require_exact();

  const Overrides& overrides_;
  Parameters kind_;
  Problem problem_;
  std::vector<Item> sections_;
  Scope constants_;                           ///< parameters, and the index of a state
  std::map<std::string, std::string> names_;  ///< and the section that they are of
  std::map<std::string, Place> group_places_;
  std::map<std::string, std::int64_t> first_of_;  ///< of indexed states
  std::set<std::size_t> unknown_;                 ///< states whose start follows from constraints
  std::vector<Place> residual_places_;
  std::vector<std::string> residual_names_;  ///< `residual 2`
  std::vector<Compartment> compartments_;
  std::vector<std::size_t> compartment_of_;  ///< by state
  std::size_t given_states_ = 0;             ///< before rates were added to them
  std::vector<std::size_t> residual_of_;     ///< by state: the one that gives its rate
};

}  // namespace odeum::formula::reading
