// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include "odeum/truth/along.hpp"
#include "odeum/truth/events_along.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

namespace {

/// Adds what the rounding of the time of a named switch moves the state by: both methods share it.
void add_rounding(const System& before, const System& after, Real t, const State& y, State& sum) {
  State f(y.size()), g(y.size());
  before.rhs(t, y.data(), f.data());
  after.rhs(t, y.data(), g.data());
  sum.resize(y.size());
  for (std::size_t i = 0; i < y.size(); ++i)
    if (const Real jump = std::abs(f[i] - g[i]); std::isfinite(jump))
      sum[i] += jump * 0x1p-63L * std::abs(before.origin + t);
}

void add(const State& more, State& sum) {
  sum.resize(std::max(sum.size(), more.size()));
  for (std::size_t i = 0; i < more.size(); ++i) sum[i] += more[i];
}

/// An insight with a later time as zero.
class LaterInsight final : public Insight {
 public:
  LaterInsight(std::unique_ptr<Insight> insight, Real origin)
      : insight_(std::move(insight)), origin_(origin) {}
  Inside look(Real t, Real h, const State& y, const State& next) override {
    return insight_->look(origin_ + t, h, y, next);
  }
  bool rounding(Real t, const State& y, State& bound) override {
    return insight_->rounding(origin_ + t, y, bound);
  }
  State spread(Real t, Real h, const State& y, const State& next) override {
    return insight_->spread(origin_ + t, h, y, next);
  }

 private:
  std::unique_ptr<Insight> insight_;
  Real origin_;
};

System later(System s, Real origin) {
  // Moves a function of the time, the state, and perhaps more.
  const auto move = [origin](auto& function) {
    if (function)
      function = [function, origin](Real t, auto&&... more) {
        return function(origin + t, std::forward<decltype(more)>(more)...);
      };
  };
  move(s.rhs);
  move(s.jacobian);
  move(s.entries);
  move(s.taylor);
  move(s.moved_rhs);
  move(s.holds);
  move(s.whole_rhs);
  if (s.insight)
    s.insight = [insight = s.insight, origin](Real span) {
      return std::make_unique<LaterInsight>(insight(span), origin);
    };
  if (s.mode_at)
    s.mode_at = [mode_at = s.mode_at, origin](Real t, const State& y, Real span, bool moved) {
      auto mode = mode_at(origin + t, y, span, moved);
      if (mode) *mode = later(*mode, origin);
      return mode;
    };
  for (Real& t : s.switches) t -= origin;
  if (s.events) {
    auto events = std::make_shared<Happenings>(*s.events);
    events->origin += origin;
    move(events->values);
    s.events = std::move(events);
  }
  s.t0 -= origin;
  s.origin += origin;
  return s;
}

/// The run of a part up to the next change, whose work, sizes and doubts are added to the whole.
Run run_of_part(Method method, System& mode, const std::vector<Real>& until, Effort effort,
                Real span, Run& whole) {
  constexpr double work_of_change = 1e4;
  mode.peaks = std::move(whole.peaks);
  // Equations with more operations than a series is made for.
  const Method used = method == taylor_run && !mode.taylor ? extrapolation_run : method;
  effort.budget -= whole.work;
  effort.inspect = true;
  effort.span = span;
  Run part = used(mode, until, effort);
  whole.work += part.work + work_of_change;
  whole.peaks = std::move(part.peaks);
  whole.reached = std::max(whole.reached, part.reached);
  if (whole.unsure.empty()) whole.sure = whole.states.size() + part.sure;
  add(part.unsure, whole.unsure);
  return part;
}

}  // namespace

System from_zero(const System& system) {
  return system.t0 == 0 ? system : later(system, system.t0);
}

namespace {

/// The next named switch after t; infinite: there is none.
Real next_switch(const System& system, Real t) {
  const auto next = std::ranges::upper_bound(system.switches, t);
  return next == system.switches.end() ? std::numeric_limits<Real>::infinity() : *next;
}

/// Whether a mode follows at t; else the run ends, in words.
bool has_mode(const System& system, const std::shared_ptr<System>& mode, bool changes_on, Real t,
              Run& whole) {
  if (mode && changes_on) return true;
  whole.end = fmt::format("{} t = {:.9Lg}",
                          mode ? "conditions change ever faster at"
                               : "the solution stays where a condition changes (sliding), from",
                          system.origin + t);
  if (!mode) whole.slides_from = system.origin + t;
  return false;
}

/// Nobody asked for the state at a switch.
void drop_last_state(Run& part, const Effort& effort) {
  part.states.pop_back();
  if (effort.watched) effort.watched->unmark();
}

}  // namespace

Run run_across(Method method, const System& system, const std::vector<Real>& times,
               const Effort& effort, bool moved) {
  if (!system.mode_at) return method(system, times, effort);
  constexpr int most_at_once = 8;  // changes at one time
  Run whole;
  whole.split = true;
  Real t = system.t0;
  State y = moved ? system.moved_y0 : system.y0;
  const Real span = times.back() - system.t0;
  std::vector<Real> left = times;
  std::shared_ptr<System> before;  // up to a named switch at t
  EventsAlong events(system, times, moved);
  if (const auto mode = system.events ? system.mode_at(t, y, span, moved) : nullptr)
    if (!events.at_time(*mode, t, y, whole)) return whole;
  for (int at_once = 0; !left.empty();) {
    const std::shared_ptr<System> mode = system.mode_at(t, y, span, moved);
    if (!has_mode(system, mode, at_once <= most_at_once, t, whole)) return whole;
    const auto next = events.settles(*mode, t, y, whole);
    if (next == EventsAlong::Next::end) return whole;
    if (next == EventsAlong::Next::again) continue;
    if (before) {
      if (whole.unsure.empty()) whole.sure = whole.states.size();
      add_rounding(*before, *mode, t, y, whole.unsure);
    }
    before = nullptr;
    mode->t0 = t;
    mode->y0 = y;
    mode->along = system.along;
    const Real by_clock = events.next(), switched = std::min(by_clock, next_switch(system, t));
    const bool to_switch = switched <= left.back();
    const auto last = to_switch ? std::ranges::lower_bound(left, switched) : left.end();
    std::vector<Real> until(left.begin(), last);
    if (to_switch) until.push_back(switched);
    Run part = run_of_part(method, *mode, until, effort, span, whole);
    const bool arrived = part.states.size() == until.size();
    if (to_switch && arrived) {
      t = switched;
      y = part.states.back();
      if (last == left.end() || *last > t) drop_last_state(part, effort);
      before = mode;
    }
    left.erase(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(part.states.size()));
    std::move(part.states.begin(), part.states.end(), std::back_inserter(whole.states));
    if (before) {
      at_once = 0;
      if (by_clock <= t && !events.at_time(*mode, t, y, whole)) return whole;
      continue;
    }
    if (!part.changed) {
      whole.end = std::move(part.end);
      whole.ends_at = part.ends_at;
      return whole;
    }
    at_once = part.changed->first - t > 0x1p-38L * span ? 0 : at_once + 1;
    t = part.changed->first;
    y = std::move(part.changed->second);
    if (!events.cross(*mode, t, y, whole)) return whole;
  }
  return whole;
}

}  // namespace odeum::truth
