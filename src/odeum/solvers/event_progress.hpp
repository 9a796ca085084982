// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "odeum/problem/events.hpp"
#include "odeum/solvers/event_finder.hpp"
#include "odeum/solvers/event_run.hpp"
#include "odeum/solvers/run_parts.hpp"
#include "odeum/solvers/solver.hpp"

namespace odeum {

inline bool same_time(double a, double b) {
  constexpr double roundings = 16 * std::numeric_limits<double>::epsilon();
  return std::isfinite(a - b) && std::abs(a - b) <= roundings * std::max(std::abs(a), std::abs(b));
}

/// What has been made of a run: the time and the state, the states at the stops passed, the events.
class EventProgress {
 public:
  EventProgress(const ErasedContest& contest, const Request& request)
      : contest_(contest),
        events_(*contest.events),
        request_(request),
        begin_(std::chrono::steady_clock::now()),
        end_(request.stops.back()),
        t_(contest.t0),
        y_(*contest.y0),
        course_(events_.course(events_.resumed)) {
    all_.t = t_;
  }

 protected:
  /// Why the run cannot be made; empty: it can.
  std::string refusal(const FixedGrid& grid) const {
    if (request_.mode == Mode::fixed && !grid.fits()) return "a stop is not on the grid of steps";
    if (end_ <= events_.known_until) return {};
    return fmt::format(
        "what happens by the clock is known up to t = {:.9g}; a run to {} needs a later `end` of "
        "the text",
        events_.known_until, end_);
  }
  /// A stop that is the same time but for rounding: no library makes a step between the two.
  double at_stop(double t) const {
    if (same_time(t, t_)) return t_;
    const auto stop =
        std::ranges::find_if(request_.stops, [&](double s) { return same_time(s, t); });
    return stop != request_.stops.end() ? *stop : std::min(t, end_);
  }
  /// The request for the part from t_ to `end`; `steps` at a fixed step.
  Request part_to(double end, std::uint64_t steps) const {
    Request part = part_of(request_, t_, end);
    part.steps = steps;
    limit(part);
    return part;
  }
  void limit(Request& part) const {
    part.budget.evaluations -= std::min(part.budget.evaluations, spent_);
    part.budget.seconds -=
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  }
  /// The work of the steps made bounds that of a run for states within them: each takes a step
  /// aside at most, of several iterations. More is spent where one ends in a pole behind an event.
  void limit_within(Request& request, const Outcome& made) const {
    limit(request);
    request.budget.evaluations = std::min(
        request.budget.evaluations, 10'000 + 4 * (detail::zero_degree + 1) * made.counters.work);
  }
  /// A library may make no step that is as short as some roundings of the time (ARKODE none below
  /// a hundred), as between the end of a step and an event just behind it: Euler's is as good.
  Outcome tried(const PartRun& run, const std::vector<double>& y0, double t0,
                const Request& request) {
    constexpr double roundings = 1024 * std::numeric_limits<double>::epsilon();
    Outcome outcome = run(t0, y0, request);
    spent_ += outcome.counters.work;
    const bool is_refused =
        outcome.status == Status::refused || outcome.status == Status::step_too_small;
    if (is_refused && request.stops.back() - t0 <= roundings * std::abs(t0))
      return by_euler(y0, t0, request);
    return outcome;
  }
  Outcome by_euler(const std::vector<double>& y0, double t0, const Request& request) const {
    Outcome outcome;
    outcome.counters.steps = outcome.counters.rhs_evaluations = outcome.counters.work = 1;
    std::vector<double> slope(y0.size()), y(y0);
    contest_.view.rhs(contest_.view.problem, t0, y0.data(), slope.data());
    for (const double t : request.stops) {
      for (std::size_t i = 0; i < y.size(); ++i) y[i] = y0[i] + (t - t0) * slope[i];
      outcome.record(t, y.data(), y.size());
    }
    return outcome;
  }

  void take(Outcome part, double end) {
    const std::size_t n = y_.size(), before = all_.states.size() / n;
    go_on_ = add_part(all_, std::move(part), request_.stops, end, y_);
    if (go_on_) t_ = end;
    for (std::size_t k = before; events_.observe && k < all_.states.size() / n; ++k)
      events_.observe(request_.stops[k], all_.states.data() + k * n);
  }
  /// Tells of the end of an accepted step, once; whether something happens there.
  bool completes(double t, const double* y) {
    if (!events_.steps || !(t > completed_)) return false;
    completed_ = t;
    return course_->completes(t, y);
  }

  /// Lets happen what happens at t_.
  void happen(const std::vector<EventCourse::Crossing>& crossings) {
    const std::string fault = course_->happen(
        t_, crossings, y_, [this](double t, const std::vector<double>& y) { return ahead(t, y); });
    for (const EventCourse::Done& done : course_->done())
      all_.events.push_back({t_, done.event, done.before, done.after});
    if (!fault.empty()) return fail(Status::refused, fault);
    // A state at the time of an event is that after it.
    const std::size_t n = y_.size(), reached = all_.states.size() / n;
    if (reached > 0 && request_.stops[reached - 1] == t_)
      std::ranges::copy(y_, all_.states.end() - static_cast<std::ptrdiff_t>(n));
    if (!course_->has_stopped()) return;
    go_on_ = false;
    all_.detail = fmt::format("an event ({}) ends it at t = {:.9g}; later states are the one there",
                              events_.names[all_.events.back().event], t_);
    for (std::size_t k = reached; k < request_.stops.size(); ++k)
      all_.record(request_.stops[k], y_.data(), n);
  }
  void happen_at(const std::vector<EventCourse::Crossing>& crossings) {
    last_gap_ = crossings_.empty() ? 0 : t_ - crossings_.back();
    crossings_.push_back(t_);
    happen(crossings);
    if (go_on_) require_way();
  }
  std::vector<int> signs_at(double t, const double* y) const {
    std::vector<double> values(events_.senses.size());
    events_.functions(t, y, values.data());
    std::vector<int> signs;
    for (const double value : values)
      signs.push_back(static_cast<int>(value > 0) - static_cast<int>(value < 0));
    return signs;
  }
  /// The signs of all functions a little after t, by a few steps of Euler's method.
  std::vector<int> ahead(double t, std::vector<double> y) const {
    constexpr int steps = 4;
    const double h = std::max(1e-9 * (end_ - contest_.t0),
                              64 * std::numeric_limits<double>::epsilon() * std::abs(t)) /
                     steps;
    std::vector<double> slope(y.size());
    for (int k = 0; k < steps; ++k) {
      contest_.view.rhs(contest_.view.problem, t + k * h, y.data(), slope.data());
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += h * slope[i];
    }
    return signs_at(t + steps * h, y.data());
  }
  /// Events without end in a finite time (Zeno), or one that calls the other (chattering).
  void require_way() {
    const double since = without_end_since(crossings_, end_ - contest_.t0);
    if (std::isnan(since)) return;
    fail(Status::step_too_small,
         fmt::format("events follow one another ever faster: over 32 of them from t = {:.9g} to "
                     "{:.9g}, and the run makes no way beyond (chattering, or infinitely many in a "
                     "finite time)",
                     since, t_));
  }
  /// Steps that were not looked into may hide events.
  void fail_unseen(const Outcome& within) {
    if (std::isfinite(within.t)) all_.t = std::min(within.t, end_);
    fail(within.status, "states within steps, where events are looked for: " + within.detail);
  }
  void fail(Status status, std::string why) {
    go_on_ = false;
    all_.status = status;
    all_.detail = std::move(why);
  }

  const ErasedContest& contest_;
  const Events& events_;
  const Request& request_;
  std::chrono::steady_clock::time_point begin_;
  double end_, t_;
  std::vector<double> y_;
  Outcome all_;
  std::unique_ptr<EventCourse> course_;
  bool go_on_ = true;
  std::uint64_t spent_ = 0;
  std::vector<double> crossings_;
  double last_gap_ = 0, completed_ = -std::numeric_limits<double>::infinity();
};

}  // namespace odeum
