// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// The events of a run.
class EventsAlong {
 public:
  EventsAlong(const System& system, const std::vector<Real>& times, bool moved)
      : events_(system.events.get()),
        system_(system),
        times_(times),
        moved_(moved),
        span_(times.back() - system.t0) {
    if (!events_) return;
    values_.resize(events_->senses.size());
    course_ = events_->course(moved);
  }

  /// The next time at which something happens by the clock: that of a time asked for where it
  /// differs by rounding alone.
  Real next() const {
    const Real t =
        events_ ? course_->next() - events_->origin : std::numeric_limits<Real>::infinity();
    if (!std::isfinite(t)) return t;
    const Real rounding = 0x1p-50L * std::abs(events_->origin + t);
    const auto near = std::ranges::lower_bound(times_, t - rounding);
    return near != times_.end() && *near <= t + rounding ? *near : t;
  }

  /// After a change of a mode at t: lets those events happen whose functions have crossed zero.
  /// False: the run ends.
  bool cross(const System& mode, Real t, State& y, Run& whole) {
    if (!events_ || values_.empty()) return true;
    const State near = times_to_zero(mode, t, y);
    Crossings crossings;
    bool happens = false;
    crossed_.assign(values_.size(), 0);
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const int side = mode.sides[k];
      if (side == 0) {
        if (is_of_condition(k) && values_[k] != 0)
          crossings.push_back({k, values_[k] > 0 ? 1 : -1}), happens = true;
        continue;
      }
      if (!(values_[k] * static_cast<Real>(side) <= 0 || near[k] < at_once * span_)) {
        if (near[k] < unclear * span_) return end(whole, t, "two events are hardly apart");
        continue;
      }
      crossed_[k] = -side;
      if (is_of_condition(k) || events_->senses[k] == 0 || events_->senses[k] == -side) {
        crossings.push_back({k, -side});
        happens = true;
      }
    }
    if (!happens) return true;
    recent_.push_back(t);
    if (recent_.size() > many && t - recent_[recent_.size() - 1 - many] <= 1e-6L * span_)
      return end(whole, t, "events follow one another ever faster");
    return happen(mode, crossings, false, t, y, whole);
  }

  /// At the start, and at a time of `next`. False: the run ends.
  bool at_time(const System& mode, Real t, State& y, Run& whole) {
    if (!events_) return true;
    crossed_.assign(values_.size(), 0);
    const Real rounding = 0x1p-50L * std::abs(events_->origin + t);
    const bool is_asked = !whole.states.empty() && whole.states.size() <= times_.size() &&
                          std::abs(times_[whole.states.size() - 1] - t) <= rounding;
    if (!happen(mode, {}, true, t, y, whole)) return false;
    if (is_asked) whole.states[whole.states.size() - 1] = y;
    return true;
  }

  enum class Next { go, again, end };
  /// Whether the mode after events is one that they leave for good. `again`: what they did made a
  /// condition change back at once, so that there is another mode.
  Next settles(const System& mode, Real t, State& y, Run& whole) {
    if (!events_ || values_.empty()) return Next::go;
    Crossings back;
    for (std::size_t k = events_->of_events; k < values_.size(); ++k)
      if (mode.sides[k] != course_->side(k)) back.push_back({k, mode.sides[k]});
    if (!back.empty()) {
      if (std::ranges::count(recent_, t) > static_cast<std::ptrdiff_t>(many))
        return end(whole, t, "events call one another without end"), Next::end;
      recent_.push_back(t);
      return happen(mode, back, false, t, y, whole) ? Next::again : Next::end;
    }
    if (recent_.empty() || recent_.back() != t) return Next::go;
    events_->values(t, y.data(), values_.data(), moved_);
    for (std::size_t k = 0; k < events_->of_events; ++k) {
      const bool fires = events_->senses[k] == 0 || events_->senses[k] == crossed_[k];
      // On the far side of a zero where its event does not happen, or away from any.
      const Real side = crossed_[k] == 0 ? values_[k] : static_cast<Real>(fires ? 0 : crossed_[k]);
      if (side * static_cast<Real>(mode.sides[k]) < 0)
        return end(whole, t, "an event is undone at once (chattering)"), Next::end;
    }
    return Next::go;
  }

 private:
  using Crossings = std::vector<ZeroCrossing>;
  static constexpr std::size_t many = 16;
  static constexpr Real at_once = 0x1p-52L, unclear = 0x1p-36L;  // of the span

  bool is_of_condition(std::size_t function) const { return function >= events_->of_events; }
  static bool end(Run& whole, Real t, const std::string& why, Real origin) {
    whole.end = fmt::format("{} at t = {:.9Lg}", why, origin + t);
    return false;
  }
  bool end(Run& whole, Real t, const char* why) const {
    return end(whole, t, why, events_->origin);
  }
  /// How long each function takes to its zero as it goes now; infinite: it goes away.
  State times_to_zero(const System& mode, Real t, const State& y) {
    const Real after = 0x1p-44L * span_;
    State slope(y.size()), next = y, later(values_.size()), times(values_.size());
    mode.rhs(t, y.data(), slope.data());
    for (std::size_t i = 0; i < y.size(); ++i) next[i] += after * slope[i];
    events_->values(t, y.data(), values_.data(), moved_);
    events_->values(t + after, next.data(), later.data(), moved_);
    for (std::size_t k = 0; k < times.size(); ++k) {
      const Real rate = (later[k] - values_[k]) / after;
      times[k] = rate * values_[k] < 0 ? -values_[k] / rate : std::numeric_limits<Real>::infinity();
    }
    return times;
  }
  bool happen(const System& mode, const Crossings& crossings, bool by_clock, Real t, State& y,
              Run& whole) {
    const State before = y;
    const auto ahead = [&](Real, const State& after) {
      const auto next = system_.mode_at(t, after, span_, moved_);
      return next ? next->sides : std::vector<int>{};
    };
    whole.end = course_->happen(events_->origin + t, crossings, y, ahead);
    if (!whole.end.empty()) return false;
    if (course_->done().empty()) return true;
    whole.happened.insert(whole.happened.end(), course_->done().size(), t);
    // The rounding of the time moves the state along both slopes.
    if (whole.unsure.empty()) whole.sure = whole.states.size();
    whole.unsure.resize(y.size());
    State f(y.size()), g(y.size());
    mode.rhs(t, before.data(), f.data());
    mode.rhs(t, y.data(), g.data());
    for (std::size_t i = 0; i < y.size(); ++i)
      if (const Real slopes = std::abs(f[i]) + std::abs(g[i]); std::isfinite(slopes))
        whole.unsure[i] += slopes * (events_->in_double ? 0x1p-50L : 0x1p-62L) *
                           std::max(std::abs(events_->origin + t), std::abs(t));
    for (std::size_t k = 0; !by_clock && k < times_.size(); ++k)
      if (std::abs(times_[k] - t) <= 0x1p-40L * span_) whole.ambiguous.push_back(k);
    if (!course_->has_stopped()) return true;
    for (std::size_t k = whole.states.size(); k < times_.size(); ++k) whole.states.push_back(y);
    return false;
  }

  const Happenings* events_;
  const System& system_;
  const std::vector<Real>& times_;
  bool moved_;
  Real span_;
  std::unique_ptr<EventCourseOf<Real>> course_;
  State values_, recent_;
  std::vector<int> crossed_;  ///< the senses in which functions crossed zero at the last change
};

}  // namespace odeum::truth
