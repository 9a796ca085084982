// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "odeum/formula/problem.hpp"
#include "odeum/problem/events.hpp"

namespace odeum::formula {

/// What the events of a text need, for any number of runs: functions, conditions, values. Several
/// threads may use it at once. Real is double or long double.
template <class Real>
struct EventRules {
  /// `constant`: replaces each constant; empty: none.
  explicit EventRules(const Problem& problem, const std::function<Real(Real)>& constant = {});

  /// What happens at a time that is known beforehand.
  struct Timed {
    Real t;
    std::size_t event;     ///< no_event: a function has a zero
    std::size_t function;  ///< of conditions
    int side;              ///< its sign from then on
  };
  /// An operation on what conditions are made of; `function`: the sign of that one decides.
  struct Step {
    Op op;
    std::array<std::size_t, 3> of;
    std::size_t function;
    Real value;
  };
  struct Condition {
    std::vector<Step> steps;
    bool is_true(const std::vector<int>& signs) const;
  };
  struct Doing {
    Evaluator<Real> values, delay, priority;
    Condition condition;
  };
  std::vector<std::string> states;
  std::vector<Event> events;
  std::vector<Watched> watched, clocked;
  Evaluator<Real> functions, clocks;  ///< those watched, and those clocked
  std::vector<Doing> doing;           ///< by event
  std::vector<Timed> timed;           ///< ascending
};

/// What events have done in a run, and what they are about to do: which conditions hold, and what
/// is delayed. Of what happens at once, what has the highest priority, then the lowest order, comes
/// first; several of the same at once, from the values before all of them. What a reset makes true
/// happens at the same time.
template <class Real>
class EventCourse final : public EventCourseOf<Real> {
 public:
  using typename EventCourseOf<Real>::State;
  using typename EventCourseOf<Real>::Crossing;
  using typename EventCourseOf<Real>::Done;
  using typename EventCourseOf<Real>::Ahead;

  /// `resumed`: what happens at the time of the first call has happened.
  EventCourse(std::shared_ptr<const EventRules<Real>> rules, bool resumed)
      : rules_(std::move(rules)), resumed_(resumed) {}

  /// A sentence where two reset one state in no order, where a value is not finite, or where events
  /// call one another without end; else empty.
  std::string happen(Real t, const std::vector<Crossing>& crossings, State& y,
                     const Ahead& ahead) override;
  const std::vector<Done>& done() const override { return done_; }
  bool has_stopped() const override { return stopped_; }
  Real next() const override;
  int side(std::size_t function) const override { return signs_[function]; }

 private:
  struct Pending {
    std::size_t event;
    Real due;
    State values;  ///< of one that has them early
  };
  void begin(Real t, const State& y);
  void take_clock(Real t, std::vector<std::size_t>& called);
  void call(std::size_t event, Real t, const State& y);
  void look_at_conditions(Real t, const State& y);
  std::vector<std::size_t> first_due(Real t, const State& y) const;
  bool carry_out(Real t, State& y);
  bool set(const std::vector<std::size_t>& group, Real t, State& y);
  bool leave_zero(Real t, const State& y, const Ahead& ahead);
  static Real rounding(Real t);

  std::shared_ptr<const EventRules<Real>> rules_;
  bool resumed_, begun_ = false, stopped_ = false;
  std::vector<int> signs_, later_;  ///< by function; later_: after a zero, unknown_side: not known
  std::vector<bool> holds_;         ///< by event
  std::vector<Pending> pending_;
  std::size_t clock_ = 0;  ///< the next of those timed
  std::vector<Done> done_;
  std::string fault_;
};

extern template struct EventRules<double>;
extern template struct EventRules<long double>;
extern template class EventCourse<double>;
extern template class EventCourse<long double>;

}  // namespace odeum::formula
