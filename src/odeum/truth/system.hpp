// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "odeum/core/error_units.hpp"
#include "odeum/core/truth_bounds.hpp"
#include "odeum/problem/events.hpp"
#include "odeum/problem/sparsity.hpp"

/// References that Odeum computes for problems without a closed form: by two methods of different
/// families in extended precision, which no competitor is (their steps, orders and programs are not
/// those of Odeum's own methods).
///
///     System system;
///     system.states = 1, system.y0 = {1};
///     system.rhs = [](Real, const Real* y, Real* f) { f[0] = -y[0]; };
///     const Reference known = compute_reference(system, {1, 2}, {});
///     // known.states[k][0] is exp(-known.times[k]); 1 and 2 are among the times
namespace odeum::linear {
struct Elimination;
}
namespace odeum::truth {

using Real = long double;
using State = std::vector<Real>;

/// What the inside of a step has that its ends do not tell, from a part of the step to another:
/// nothing; something too narrow for its samples; or a condition that changes.
struct Inside {
  enum class Kind { nothing, hidden, change };
  Kind kind = Kind::nothing;
  Real from = 0, to = 1;
};
/// What the operations of a right-hand side tell beside its values; for one run.
class Insight {
 public:
  virtual ~Insight() = default;
  /// Looks into the step of h from (t, y) to `next`.
  virtual Inside look(Real t, Real h, const State& y, const State& next) = 0;
  /// A bound of the rounding of f at (t, y) in extended precision, by component; false: not known.
  virtual bool rounding(Real /*t*/, const State& /*y*/, State& /*bound*/) { return false; }
  /// How much f may vary within a step that is too short to be looked into, by component.
  virtual State spread(Real /*t*/, Real /*h*/, const State& y, const State& /*next*/) {
    return State(y.size());
  }
};

struct Along;
class Watched;
/// Part of itself, see System::moved_rhs and Effort::disturb.
inline constexpr Real moved_by = 0x1p-40L;

/// What happens to a solution at times, where functions of it cross zero, and where conditions on
/// their signs become true.
struct Happenings {
  std::vector<int> senses;    ///< by function: 1 rising, -1 falling, 0 either
  std::size_t of_events = 0;  ///< so many functions are those of events, the others of conditions
  Real origin = 0;            ///< what is added to a time
  bool in_double = false;     ///< states and times are rounded to double at events
  /// The functions, on constants that are moved or not.
  std::function<void(Real t, const Real* y, Real* values, bool moved)> values;
  std::function<std::unique_ptr<EventCourseOf<Real>>(bool moved)> course;  ///< of one run
};

/// An initial value problem in extended precision. Times and states are in the problem's units; y,
/// f and State have `states` numbers. `states`, `y0` and `rhs` are required. `entries` comes with
/// `sparsity` and in place of `jacobian`, `moved_rhs` with `moved_y0`, `mode_at` with `moved_y0`
/// where `smooth` is false; `holds` and `whole_rhs` belong to what `mode_at` returns. All else may
/// be empty.
struct System {
  std::size_t states = 0;
  Real t0 = 0;
  Real origin = 0;  ///< what messages add to a time, see from_zero()
  State y0;
  std::function<void(Real t, const Real* y, Real* f)> rhs;
  std::function<void(Real t, const Real* y, Real* j)> jacobian;  ///< dense, row-major
  /// Many states whose Jacobian has few entries: its pattern and values, instead of `jacobian`; and
  /// how it is eliminated, null: as a band.
  std::shared_ptr<const Sparsity> sparsity;
  std::shared_ptr<const linear::Elimination> elimination;
  std::function<void(Real t, const Real* y, Real* values)> entries;
  /// Coefficients of the Taylor series, see WithTaylorSeries; empty: none.
  std::function<void(Real t, const Real* y, int order, Real* c)> taylor;
  /// The right-hand side with every constant and initial value that rounding has moved (decimals,
  /// roots) changed by `moved_by` of itself: how rounding of constants acts.
  std::function<void(Real t, const Real* y, Real* f)> moved_rhs;
  State moved_y0;
  State peaks;  ///< what each component has come to before t0; empty: it begins there
  bool smooth = true;
  /// For a run of the length `span`; empty: there is none.
  std::function<std::unique_ptr<Insight>(Real span)> insight;
  /// For equations with kinks, a smooth system that holds from (t, y) on until `holds` is not
  /// positive, on constants that are moved or not; null: none does, since the solution stays where
  /// a condition changes.
  std::function<std::shared_ptr<System>(Real t, const State& y, Real span, bool moved)> mode_at;
  /// Times, ascending, at which steps end, since one mode ends and another one begins there.
  State switches;
  /// With `mode_at`: events; null: there are none.
  std::shared_ptr<const Happenings> events;
  /// The signs that a mode's functions of events have as long as it holds.
  std::vector<int> sides;
  std::function<Real(Real t, const Real* y)> holds;
  /// The right-hand side of which this is a mode; empty: it is not a mode.
  std::function<void(Real t, const Real* y, Real* f)> whole_rhs;
  /// Whether several threads may call the functions at once.
  bool concurrent = false;
  Real rounding = 0x1p-63L;  ///< of the right-hand side, relative: that of double for foreign code
  double work = 10;          ///< operations of one evaluation, for the budget
  /// What its components are along the solution, see Sizes; null: not known.
  std::shared_ptr<const Along> along;

  bool has_jacobian() const { return jacobian || entries; }
};

/// Unknowns: full matrices of more take too long in extended precision.
inline constexpr std::size_t most_in_matrix = 64;

/// A function of a problem in double, of n unknowns, for numbers of extended precision. The runs
/// allow for a Jacobian of double: Newton's method corrects what it is off, and the extrapolated
/// Euler method has its order with any matrix.
template <class Function>
auto widened(std::size_t n, std::size_t results, Function function) {
  return [=](Real t, const Real* y, Real* out) {
    const std::vector<double> state(y, y + n);
    std::vector<double> values(results);
    function(static_cast<double>(t), state.data(), values.data());
    std::ranges::copy(values, out);
  };
}

/// The states at times, as far as a run came.
struct Run {
  std::vector<State> states;  ///< one a time; fewer where the run ended early
  std::string end;            ///< why it ended early; empty: it did not
  double work = 0;            ///< operations spent
  Real reached = 0;           ///< the time
  /// Where the slope of the solution grows without bound, at a pole or a root: it ends there.
  /// Infinite: nowhere that is known.
  Real ends_at = std::numeric_limits<Real>::infinity();
  /// From where on it stays where a condition changes; infinite: it does not.
  Real slides_from = std::numeric_limits<Real>::infinity();
  bool split = false;  ///< steps were shortened for what was found inside of them
  /// The time just after a condition has changed, at which the run ended, and the state there.
  std::optional<std::pair<Real, State>> changed;
  /// For each component, what steps too short to be looked into may hide, and what the rounding of
  /// the times of switches moves; empty: nothing.
  State unsure;
  std::size_t sure = 0;  ///< how many of the first states are not moved by that
  State peaks;           ///< the largest of each component
  /// The numbers of the times so close to an event that rounding decides on which side they are.
  std::vector<std::size_t> ambiguous;
  State happened;  ///< the times of events
  std::ptrdiff_t events_before(Real t) const {
    return std::ranges::count_if(happened, [t](Real at) { return at < t; });
  }
};

using Moment = TruthBounds::Moment;

/// What a run may cost and how accurate each of its steps is to be.
struct Effort {
  Real tolerance = 1e-18L;          ///< per step, relative to the size of the solution
  double budget = 3e9;              ///< operations
  bool inspect = false;             ///< look into each step
  Real span = 0;                    ///< of the whole, of which a run is a part; 0: it is the whole
  bool disturb = false;             ///< change each state by `moved_by` of itself after a step
  Moment until = Moment::max();     ///< see TruthBounds
  Real parts = 50;                  ///< of the span, one of which no step is longer than
  Watched* watched = nullptr;       ///< sees each step; null: nothing does
  Real least_part = 1e-6L;          ///< of the largest size, by which small components are measured
  const State* at_least = nullptr;  ///< magnitudes at which components are held; null: none are
};

using Method = Run (*)(const System&, const std::vector<Real>& times, const Effort&);

/// Taylor's method, order 28 (needs `taylor`).
Run taylor_run(const System& system, const std::vector<Real>& times, const Effort& effort);
/// Gragg's extrapolation, order 14.
Run extrapolation_run(const System& system, const std::vector<Real>& times, const Effort& effort);
/// Verner's pair 9(8), coefficients of 20 digits.
Run verner_run(const System& system, const std::vector<Real>& times, const Effort& effort);
/// Radau IIA of seven stages, order 13 (needs a Jacobian): for stiff problems.
Run radau_run(const System& system, const std::vector<Real>& times, const Effort& effort);
/// Extrapolation of the linearly implicit Euler method, order 8 (needs a Jacobian): likewise.
Run implicit_extrapolation_run(const System& system, const std::vector<Real>& times,
                               const Effort& effort);

/// The finest tolerance of the latter where f is exact to extended precision: the weights of its
/// table amplify rounding by some hundreds.
inline constexpr Real finest_implicit_extrapolation = 1e-16L;

/// The same with the time since the start as its time, whose rounding at the start is none: a
/// transient may be shorter than the last place of t0.
System from_zero(const System& system);

/// A run across all changes of conditions, in a smooth system between two of them.
Run run_across(Method method, const System& system, const std::vector<Real>& times,
               const Effort& effort, bool moved);

inline bool is_past(Moment moment) { return std::chrono::steady_clock::now() > moment; }

/// A computed reference.
struct Reference {
  std::vector<double> times;  ///< at which it is known: those asked for, and others between
  std::vector<State> states;
  /// For each time, bounds of the error of each component, in its own unit, in extended precision.
  std::vector<std::vector<double>> floors;
  double known_until = 0;  ///< the last time that was looked at and is known
  std::string end;         ///< why nothing is known beyond; empty: all is known
  /// After this time there is no solution: its slope grows without bound; infinite: not known.
  double ends_at = std::numeric_limits<double>::infinity();
  /// Where the work or the seconds were spent before the end: the time to which both methods came
  /// in `seconds`; not kept.
  double spent_at = std::numeric_limits<double>::infinity();
  double seconds = 0;
  bool is_explicit = false;  ///< both methods are; not kept
  std::string methods;       ///< which two, in words
  double disagreement = 0;   ///< largest over the times, of a component over its unit
};

/// The exact states at the times (ascending) to as many digits as two methods agree on. The
/// tolerances are refined until the runs agree no better. A floor is their disagreement, with a
/// safety factor, and what the rounding of constants adds. Where they
/// agree on less than 1e-6 of the solution, both in these units, nothing is known. Where the system
/// is `concurrent`, up to three threads call its functions. Throws Interrupted, and what they
/// throw.
Reference compute_reference(const System& system, const std::vector<double>& times,
                            const ErrorUnits& units, const TruthBounds& bounds = {});

/// As text, to be kept in a file, and back; nothing for a text that is damaged or of other sizes.
std::string to_text(const Reference& reference);
std::optional<Reference> from_text(const std::string& text, std::size_t states);

/// The reference that the cache folder keeps for this content, else a computed one, which is then
/// kept there; nothing where none could be computed.
std::optional<Reference> kept_or_computed(std::string content, std::size_t states,
                                          const std::vector<double>& stops, const ErrorUnits& units,
                                          const TruthBounds& bounds,
                                          const std::function<std::optional<Reference>()>& compute);

}  // namespace odeum::truth
