// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "odeum/core/error_units.hpp"
#include "odeum/core/request.hpp"
#include "odeum/core/truth_bounds.hpp"
#include "odeum/solvers/entrants.hpp"

namespace odeum {

namespace cases {
struct TextSource;
}

/// The independent reference: the exact state at a time.
struct Truth {
  /// Fills the state at t, as many numbers as the case's y0, infinite past the end of the solution
  /// (a pole); false: not known. Several threads may call it at once.
  std::function<bool(double t, double* y)> at;
  double floor = 0;  ///< largest error of the truth itself, in the units of the case's errors
  std::vector<double> floors;  ///< by component, in its own unit; empty: see Case::floor_of
  std::string source;          ///< closed form, or the reference file
  /// It is a closed form, which follows other values of the parameters.
  bool closed_form = false;
  /// The largest magnitude and the lowest value of each component from the start to the last stop,
  /// in its own unit; empty: not known.
  std::vector<double> largest, lowest;
};

/// A problem whose parameters a study changes between solves. On the `lambda` plane it is y' =
/// (first + i second) y from y = (1, 0); on the `oscillator` plane q'' = -2 zeta w q' - w^2 q with
/// w = first and zeta = second, from q = 1, q' = 0; `undamped` is the latter with zeta = 0, as a
/// problem that also fits methods for separable systems. t0 is 0.
struct Probe {
  Entrants entrants;
  std::function<void(double first, double second)> place;
};

/// An invariant of the exact solution, besides its energy.
struct Invariant {
  std::string name;  ///< angular_momentum, mass, ...
  std::function<double(const double* y)> value;
};

/// A number of a case that a user may change.
struct Parameter {
  std::string name;
  double value = 0;
  std::string meaning;  ///< with its unit
};

/// The solvers on one problem whose parameters change between solves. For one thread: no solve may
/// run while `place` does.
struct Family {
  Entrants entrants;
  std::shared_ptr<const std::vector<double>> y0;  ///< of the values that were placed last
  std::function<double(const double* y)> energy;  ///< likewise; empty where there is none
  /// Values of all parameters, in the case's order. Throws std::invalid_argument for those that
  /// make no problem.
  std::function<void(const std::vector<double>& values)> place;
};

/// What is known of a case by its equations, its forces or trial runs. Studies decide by it, and
/// never by a tag, which anybody may write.
struct Nature {
  bool linear = false;  ///< in the state
  bool autonomous = true;
  bool smooth = false;  ///< methods of every order converge visibly within the budget
  bool stiff = false;   ///< explicit methods need many more steps than implicit ones
  bool chaotic = false;
  /// The highest order that any method has on it, by the derivative of the right-hand side that
  /// jumps.
  double highest_order = std::numeric_limits<double>::infinity();
};

/// How studies choose the settings of their solves on a case.
struct StudySettings {
  /// Why no solver runs at a fixed step, and why the convergence study leaves the case out; empty
  /// where neither holds.
  std::string no_fixed_steps, no_convergence;
  /// The convergence study runs to the first stop alone: after it no order shows at steps that the
  /// budget allows.
  bool orders_to_first_stop = false;
  /// It spends the budget of the case, as on smooth ones, and not that of hard problems.
  bool orders_in_full = false;
  std::uint64_t steps_multiple = 1;    ///< every fixed-step count is a multiple of it (stops)
  std::uint64_t coarsest_steps = 16;   ///< the convergence study's smallest count for order 4
  std::uint64_t finest_steps = 16384;  ///< and its largest, once it has eight
  /// Where timed studies measure the error, and the truth's floor there; empty: at the case's
  /// stops.
  std::vector<double> timed_stops;
  double timed_floor = 0;
  /// What one solve may cost, in evaluations of the right-hand side and products of its derivative
  /// with a vector, those of the problem's own solver of linear systems among them.
  std::uint64_t evaluation_budget = 500'000;
};

/// Quantities that are not components: observables of a network, rates, volumes.
struct Outputs {
  std::vector<std::string> names;
  /// Their values, as many.
  std::function<void(double t, const double* y, double* values)> at;
};

/// What was found in a statement, for people: a name of one word, and a text.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// A problem with all that is needed to run solvers on it and to measure their errors. Times are in
/// the problem's unit, states have as many numbers as y0, each in its own. Several threads may use
/// a case that nobody changes; copies share the problem and the entrants.
struct Case {
  // Defined in case.cpp: each is as long as this list, and every file with a case would compile it.
  Case();
  Case(const Case&);
  Case(Case&&) noexcept;
  Case& operator=(const Case&);
  Case& operator=(Case&&) noexcept;
  ~Case();

  std::string id;
  std::string title;
  std::string equation;
  std::string source;             ///< where the equation and its parameters come from
  std::vector<std::string> tags;  ///< words of its author; see tags_of
  Nature nature;
  Facts facts;

  double t0 = 0;
  std::vector<double> y0;
  /// Names of the components, as columns of files have them; empty: see component_names.
  std::vector<std::string> components;
  /// Where the error is measured; the last is the horizon of studies. On the grid of every
  /// fixed-step run.
  std::vector<double> stops;
  /// Where the stops were cut, since no truth is known beyond them: the time that was asked for.
  double asked_end = -std::numeric_limits<double>::infinity();
  Truth truth;
  /// The components whose error is reported; empty: all of them.
  std::vector<std::size_t> measured;
  /// Whether these are the places of particles, x, y and z of each: an error is then a distance.
  bool measures_particles = false;
  ErrorUnits units;
  /// What its author asks for; a relative one of 0: none. Its thresholds hold for runs to other
  /// relative tolerances too.
  Tolerance tolerance = 0;
  std::function<double(const double* y)> energy;  ///< empty where the problem has none
  std::vector<Invariant> invariants;
  Outputs outputs;
  /// What a scheme gives after `steps` steps of h by a closed form of its own, for a few solvers of
  /// a few cases; false where none is known.
  std::function<bool(const std::string& solver, double h, double steps, double* y)> scheme;
  /// What a user may change, and the same case with other values of all of them (in this order),
  /// truth included: a closed form follows, a reference file no longer holds. Throws
  /// std::invalid_argument for values that make no problem.
  std::vector<Parameter> parameters;
  std::function<Case(const std::vector<double>& values, const TruthBounds& bounds)> with_values;
  /// Makes a family of the case with other values of its parameters, where they can change without
  /// a new case: on `samples` its problems were found to be those of with_values. None: they are
  /// not. Empty: there is no such function.
  std::function<std::optional<Family>(const std::vector<std::vector<double>>& samples)> family;
  /// Computes the truth where that takes long, and sets what follows from it: the stops at which it
  /// is known, the settings of studies, facts. Empty: that is done, see complete().
  std::function<void(Case&, const TruthBounds& bounds)> compute_truth;
  /// The text that states the case; null: none does.
  std::shared_ptr<const cases::TextSource> text;
  ErasedContest problem;                            ///< on which the entrants are enrolled
  std::shared_ptr<const ExtendedProblem> extended;  ///< null: none

  StudySettings settings;

  Entrants entrants;
  /// Cases with a parameter plane: its kind (`lambda`, `oscillator`, `undamped`), and a function
  /// that makes an independent probe of it, one for each thread.
  std::string plane;
  std::function<Probe()> probe;

  /// Where a run ends that is not told otherwise, whatever is known there.
  double end() const { return std::max(stops.back(), asked_end); }
  const std::vector<double>& timed_stops() const {
    return settings.timed_stops.empty() ? stops : settings.timed_stops;
  }
  /// Absolute error of the truth at the timed stops.
  double timed_floor() const {
    return settings.timed_stops.empty() ? truth.floor : settings.timed_floor;
  }
  double scale_of(std::size_t component) const { return units.scale_of(component); }
  /// Error of the truth's component, in its own unit.
  double floor_of(std::size_t component) const {
    return truth.floors.empty() ? truth.floor * scale_of(component) : truth.floors[component];
  }
};

/// Computes the truth of a case that was made before it; nothing where it is there. Throws
/// InputError for a statement that the truth contradicts (an invariant that is not kept).
void complete(Case& c, const TruthBounds& bounds = {});

/// The words for the case's nature, and its tags that are none of these.
std::vector<std::string> tags_of(const Case& c);

/// The case's own names of its components, or y0, y1, ...; of second-order problems q0, ..., v0,
/// ...
std::vector<std::string> component_names(const Case& c);

/// Asks for a relative tolerance, and for the absolute ones of the case's thresholds.
void set_tolerance(Request& request, const Case& c, double relative);

/// A library that Odeum has an adapter for, and whether this build has it.
struct LibraryInfo {
  std::string name;                    ///< folder under adapters/
  std::vector<std::string> libraries;  ///< the first parts of its solver ids
  std::string option;                  ///< the CMake option
  bool built = false;
  std::string version;  ///< empty where not built
};
const std::vector<LibraryInfo>& all_libraries();

}  // namespace odeum
