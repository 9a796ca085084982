// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>
#include <vector>

#include "odeum/core/tolerance.hpp"
#include "odeum/formula/evaluator.hpp"
#include "odeum/formula/event.hpp"
#include "odeum/formula/graph.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::formula {

/// A quantity that the exact solution keeps.
struct Invariant {
  std::string name;
  Id value = no_node;
  Place place;
  bool is_found = false;  ///< in the stoichiometry of reactions, which proves it

  bool is_energy() const { return name == "energy" || name == "H"; }
};

/// A quantity that is not a state, in a column of its own.
struct Output {
  std::string name;
  Id value = no_node;
};

/// A constraint on states, or what its derivatives say of them: zero along the solution.
struct StateConstraint {
  std::string name;  ///< as in `constraint 1, differentiated twice`
  Id value = no_node;
  bool is_hidden = false;
};

/// An initial value problem that was read from a file: y' = equations, all in one graph.
struct Problem {
  std::string file, name;
  Graph graph;
  std::vector<std::string> states;  ///< their names, u[3] for an element
  std::vector<Place> places;        ///< of the equation of each state
  std::vector<long double> y0;
  std::vector<Id> start;  ///< y0 as expressions of the parameters
  std::vector<Id> equations;
  /// The equations as two parts by state, of which additive methods solve for the second; empty:
  /// not split.
  std::vector<Id> explicit_part, implicit_part;
  std::map<std::string, long double> parameters;
  long double t0 = 0;
  std::vector<double> stops;  ///< where errors are measured; the last is the end
  std::vector<Id> exact;      ///< by state, in t; empty: not known
  std::vector<Place> exact_places;
  std::vector<Invariant> invariants;
  std::vector<Output> outputs;
  std::vector<double> scale;  ///< by state; empty: 1
  Tolerance tolerance = 0;    ///< that runs are asked for; a relative one of 0: none given
  /// The equations as text, for people: `x' = ...`, in the order of the file.
  std::string equations_text;
  Id kinetic_energy = no_node;  ///< v M v / 2 where the file has a mass matrix M
  std::string mass_text;        ///< M, for people
  std::vector<Event> events;
  std::string events_text;       ///< all that they depend on, as text
  long double events_until = 0;  ///< how far the times of events are known, beyond the end
  /// Functions that decide what happens and have to be watched along the solution, those of events
  /// first; and those whose zeros are known.
  std::vector<Watched> watched, clocked;
  /// The numbers of the functions of comparisons in conditions: those of `watched`, then `clocked`.
  std::map<Id, std::size_t> comparisons;
  /// R(t, y, y') = 0 where not all rates could be solved for, one for each state, constraints among
  /// them, with the rates as the states from first_rate on (formula/reduction.hpp); empty: none.
  std::vector<Id> residuals;
  std::vector<StateConstraint> constraints;  ///< those that are given, then hidden ones
  int index = 0;                             ///< of the constraints; 0: there are none
  std::vector<int> indices;                  ///< of the states; empty: 1
  std::string jumps;  ///< why states jump with a constraint; empty: none was found that does
  /// What people read of residuals, in place of which `equations` stand: names and texts.
  std::vector<std::pair<std::string, std::string>> notes;
};

inline constexpr std::size_t most_states = 100'000;  ///< each is an equation of the C code

/// Values that replace those of parameters: name and expression.
using Overrides = std::map<std::string, std::string>;

/// Whether parameters are put in as numbers, or keep their names (Graph::named), for code that is
/// to be printed.
enum class Parameters { numbers, names };

/// Reads a problem file (cases/problems/README.md has the format). Throws InputError with the place
/// for every mistake: an unknown name or key, a state without an equation, a definition that needs
/// a later one, residuals that are too few, of an index above 3, or that the start does not fulfil,
/// what the limits of formula/parser.hpp exclude, an equation that is not finite at the start, an
/// `exact` that does not fulfil the equations or the initial values, an invariant that changes at
/// the start, an event that does nothing, or two that contradict each other.
Problem read_problem(const std::string& file, const std::string& text,
                     const Overrides& overrides = {}, Parameters kind = Parameters::numbers);
/// The text of a problem file. Throws InputError for a file that cannot be read or is too large.
std::string problem_text(const std::string& file);
inline constexpr std::size_t most_problem_bytes = 8'000'000;

/// Whether the text is a YAML mapping with a key that problem files have and scenes have not.
bool looks_like_problem(const std::string& file, const std::string& text);

/// Throws InputError where an invariant changes along the equations at (t, y): its derivative is
/// not rounding.
void require_invariants(Problem& problem, long double t, const long double* y);

}  // namespace odeum::formula
