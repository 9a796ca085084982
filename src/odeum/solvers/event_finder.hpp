// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <vector>

#include "odeum/control/zeros.hpp"
#include "odeum/problem/events.hpp"

namespace odeum {

/// The functions of events along the steps of a run.
class EventFinder {
 public:
  using StateAt = std::function<bool(double t, double* y)>;  ///< false: there is none

  /// The events that happen first, at once; none: no event.
  struct Found {
    double t = 0;
    std::vector<std::size_t> functions;
    bool of_step = false;  ///< at the end of one, by the problem's own word
    explicit operator bool() const { return of_step || !functions.empty(); }
  };

  /// `events` has to outlive this.
  EventFinder(const Events& events, std::size_t states);

  /// After events at a time, or at a start (none of them); with the signs that the run has.
  /// `before`: the state there before them, which is not exactly at the zeros; empty: not known.
  void begin(const Found& happened, const EventCourse& course, const std::vector<double>& before);
  /// What crossed zero at the time found last.
  std::vector<EventCourse::Crossing> crossings(const Found& found) const;
  /// Looks at a step whose states are given: the first events in it.
  Found look(double a, double b, const StateAt& state);
  /// What it has learnt of the steps up to now, to come back to.
  std::vector<ZeroSearch> searches() const { return searches_; }
  void restore(std::vector<ZeroSearch> searches) {
    searches_ = std::move(searches);
    rests_known_ = false;
  }

 private:
  double value(std::size_t function, double t, const StateAt& state);
  /// Functions that are zero at t but for the rounding of the state and of the time rest there, as
  /// after an event that makes the threshold itself an equilibrium.
  void find_rests(double t, const StateAt& state);

  const Events& events_;
  std::vector<double> y_, values_;
  std::vector<ZeroSearch> searches_;
  std::vector<int> senses_;  ///< by function: in which it crossed zero with the events found last
  Found before_;             ///< what happened before that
  bool rests_known_ = false;
};

/// The states of a step by the polynomial through those at its nine nodes (zero_nodes).
class StepPolynomial {
 public:
  /// `states`: n numbers at each node, which have to outlive this.
  StepPolynomial(double a, double b, const std::vector<const double*>& states, std::size_t n)
      : a_(a), b_(b), states_(states), n_(n) {}
  bool operator()(double t, double* y) const;

 private:
  double a_, b_;
  const std::vector<const double*>& states_;
  std::size_t n_;
};

}  // namespace odeum
