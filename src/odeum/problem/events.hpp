// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace odeum {

/// A function that crosses zero, and its sign from then on; 0: it touches zero.
struct ZeroCrossing {
  std::size_t function;
  int side;
};

/// What the events of a problem have done in one run, and what they are about to do. Real is double
/// or long double.
template <class Real>
class EventCourseOf {
 public:
  using State = std::vector<Real>;
  using Crossing = ZeroCrossing;
  /// An event, and the states before and after what happened with it at once.
  struct Done {
    std::size_t event;
    State before, after;
  };
  /// The signs of all functions a little later; an empty list where they are not known.
  using Ahead = std::function<std::vector<int>(Real t, const State& y)>;

  virtual ~EventCourseOf() = default;
  /// Lets happen what happens at t; the first call is that at the start. Gives y the values after
  /// it; a sentence where that cannot be, else empty.
  virtual std::string happen(Real t, const std::vector<Crossing>& crossings, State& y,
                             const Ahead& ahead) = 0;
  virtual const std::vector<Done>& done() const = 0;  ///< by the last call
  /// The solution stays as it is from now on.
  virtual bool has_stopped() const = 0;
  /// The next time at which something happens by the clock; infinite: never.
  virtual Real next() const = 0;
  /// The sign that a function has had since the last call; 0: it is zero and stays so.
  virtual int side(std::size_t function) const = 0;
  /// Where Events::steps asks for it, after each accepted step, in their order: whether something
  /// happens at its end.
  virtual bool completes(Real /*t*/, const Real* /*y*/) { return false; }
};
using EventCourse = EventCourseOf<double>;

/// What happens to a solution at times, where functions of the time and of it cross zero, and where
/// conditions on their signs become true. Times and states are in the problem's units; y has the
/// problem's size. Several threads may call the functions at once.
struct Events {
  std::vector<std::string> names;  ///< of all events, for people
  std::vector<bool> stops;         ///< by event: it ends the solution
  /// Where an event of each function happens: where it rises (1), falls (-1), or both (0).
  std::vector<int> senses;
  /// So many functions are those of events; the signs of the others decide conditions.
  std::size_t of_events = 0;
  /// Fills values with the functions.
  std::function<void(double t, const double* y, double* values)> functions;
  /// For one run; `resumed`: what happens at its start has happened.
  std::function<std::unique_ptr<EventCourse>(bool resumed)> course;
  bool resumed = false;
  /// A run cannot be resumed at any time: its state does not tell all, as of delays and models.
  bool remembers = false;
  bool steps = false;  ///< a course is told of the ends of steps
  bool modal = false;  ///< the functions may be others after each event
  /// They are foreign code, which runs in processes of its own alone.
  bool isolated = false;
  /// Gives a state at a stop the values to be shown there; empty: those it has.
  std::function<void(double t, double* y)> observe;
  double known_until = std::numeric_limits<double>::infinity();  ///< by the clock
};

}  // namespace odeum
