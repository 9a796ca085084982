// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// The events of a run.
class EventsAlong {
 public:
  EventsAlong(const System& system, const std::vector<Real>& times, bool moved)
      : events_(system.events.get()), times_(times), moved_(moved), origin_(system.origin) {
    if (events_) values_.resize(events_->senses.size());
    span_ = times.back() - system.t0;
  }

  /// After a change of a mode at t: lets those events happen whose functions have crossed zero.
  /// False: the run ends.
  bool cross(const System& mode, Real t, State& y, Run& whole) {
    if (!events_ || values_.empty()) return true;
    const State near = times_to_zero(mode, t, y);
    std::vector<std::size_t> happened;
    crossed_.assign(values_.size(), 0);
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const int side = mode.sides[k];
      if (side == 0 || !(values_[k] * static_cast<Real>(side) <= 0 || near[k] < at_once * span_)) {
        if (side != 0 && near[k] < unclear * span_)
          return end(whole, t, "two events are hardly apart");
        continue;
      }
      crossed_[k] = -side;
      if (events_->senses[k] == 0 || events_->senses[k] == -side) happened.push_back(k);
    }
    if (happened.empty()) return true;
    recent_.push_back(t);
    if (recent_.size() > many && t - recent_[recent_.size() - 1 - many] <= 1e-6L * span_)
      return end(whole, t, "events follow one another ever faster");
    return happen(mode, happened, events_->times.size(), t, y, whole);
  }

  /// Lets the events at a time that ends a mode happen, if any.
  bool at_time(const System& mode, Real t, State& y, Run& whole) {
    if (!events_) return true;
    crossed_.assign(values_.size(), 0);
    const Real rounding = 0x1p-50L * std::abs(origin_ + t);
    const auto next = std::ranges::lower_bound(events_->times, t - rounding);
    if (next == events_->times.end() || *next > t + rounding) return true;
    const bool is_asked = !whole.states.empty() && whole.states.size() <= times_.size() &&
                          std::abs(times_[whole.states.size() - 1] - t) <= rounding;
    if (!happen(mode, {}, static_cast<std::size_t>(next - events_->times.begin()), t, y, whole))
      return false;
    if (is_asked) whole.states[whole.states.size() - 1] = y;
    return true;
  }

  /// Whether the mode after events is one that they leave for good. False: the run ends.
  bool settles(const System& mode, Real t, const State& y, Run& whole) {
    if (!events_ || values_.empty()) return true;
    for (std::size_t k = 0; k < values_.size(); ++k)
      if (mode.sides[k] == 0) return end(whole, t, "the expression of an event stays zero");
    if (recent_.empty() || recent_.back() != t) return true;
    events_->values(t, y.data(), values_.data(), moved_);
    for (std::size_t k = 0; k < values_.size(); ++k) {
      const bool fires = events_->senses[k] == 0 || events_->senses[k] == crossed_[k];
      // On the far side of a zero where its event does not happen, or away from any.
      const Real side = crossed_[k] == 0 ? values_[k] : static_cast<Real>(fires ? 0 : crossed_[k]);
      if (side * static_cast<Real>(mode.sides[k]) < 0)
        return end(whole, t, "an event is undone at once (chattering)");
    }
    return true;
  }

  bool ended() const { return ended_; }

 private:
  static constexpr std::size_t many = 16;
  static constexpr Real at_once = 0x1p-52L, unclear = 0x1p-36L;  // of the span

  bool end(Run& whole, Real t, const char* why) {
    ended_ = true;
    whole.end = fmt::format("{} at t = {:.9Lg}", why, origin_ + t);
    return false;
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
  bool happen(const System& mode, const std::vector<std::size_t>& functions, std::size_t timed,
              Real t, State& y, Run& whole) {
    const State before = y;
    bool stops = false;
    const std::string fault = events_->apply(t, functions, timed, y, moved_, stops);
    if (!fault.empty()) {
      ended_ = true;
      whole.end = fault;
      return false;
    }
    // The rounding of the time moves the state along both slopes.
    if (whole.unsure.empty()) whole.sure = whole.states.size();
    whole.unsure.resize(y.size());
    State f(y.size()), g(y.size());
    mode.rhs(t, before.data(), f.data());
    mode.rhs(t, y.data(), g.data());
    for (std::size_t i = 0; i < y.size(); ++i)
      if (const Real slopes = std::abs(f[i]) + std::abs(g[i]); std::isfinite(slopes))
        whole.unsure[i] += slopes * 0x1p-62L * std::max(std::abs(origin_ + t), std::abs(t));
    for (std::size_t k = 0; timed == events_->times.size() && k < times_.size(); ++k)
      if (std::abs(times_[k] - t) <= 0x1p-40L * span_) whole.ambiguous.push_back(k);
    if (!stops) return true;
    ended_ = true;
    for (std::size_t k = whole.states.size(); k < times_.size(); ++k) whole.states.push_back(y);
    return false;
  }

  const Happenings* events_;
  const std::vector<Real>& times_;
  bool moved_;
  Real origin_, span_;
  State values_, recent_;
  std::vector<int> crossed_;  ///< the senses in which functions crossed zero at the last change
  bool ended_ = false;
};

}  // namespace odeum::truth
