// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "odeum/core/status.hpp"

/// What may be attached to a run of odeum::integrate: any number of
///
///     each_step(f)                 f(t, y) after each step; returns false to end the run there
///     at_times(times, f)           f(t, y) at each of the ascending times within the run
///     until_event(g, direction)    ends the run at the first sign change of g(t, y)
///
/// Times are double, in the problem's unit; y is the state, of the problem's size and valid during
/// the call. All are called on the thread of the run, and what they throw ends it without a RunEnd.
namespace odeum {

template <class F>
class EachStep {
 public:
  explicit EachStep(F f) : f_(std::move(f)) {}
  /// False: the run ends.
  template <class Step>
  bool report(Step& step, Status&) {
    using Answer = decltype(f_(step.end(), step.end_state()));
    if constexpr (std::is_convertible_v<Answer, bool>)
      return f_(step.end(), step.end_state());
    else
      f_(step.end(), step.end_state());
    return true;
  }

 private:
  F f_;
};

/// After each step, `f(t, y)`; where it returns bool, false ends the run.
template <class F>
EachStep<F> each_step(F f) {
  return EachStep<F>(std::move(f));
}

template <class F>
class AtTimes {
 public:
  AtTimes(std::vector<double> times, F f) : times_(std::move(times)), f_(std::move(f)) {}
  template <class S>
  void begin(double t0, const S& y0) {
    while (next_ < times_.size() && times_[next_] < t0) ++next_;
    for (; next_ < times_.size() && times_[next_] == t0; ++next_) f_(t0, y0);
  }
  template <class Step>
  bool report(Step& step, Status& status) {
    for (; next_ < times_.size() && times_[next_] <= step.end(); ++next_) {
      const bool at_end = times_[next_] == step.end();
      if (!at_end) status = step.at(times_[next_], step.inner());
      if (status != Status::ok) return false;
      f_(times_[next_], at_end ? step.end_state() : std::as_const(step.inner()));
    }
    return true;
  }

 private:
  std::vector<double> times_;
  F f_;
  std::size_t next_ = 0;
};

/// At each of the ascending times within the run, `f(t, y)`. The steps are not steered by them: y
/// is found within the step, see Inside in api/between.hpp.
template <class F>
AtTimes<F> at_times(std::vector<double> times, F f) {
  return AtTimes<F>(std::move(times), std::move(f));
}

/// Which sign changes count.
enum class Crossing { any, rising, falling };

template <class G>
class UntilEvent {
 public:
  UntilEvent(G g, Crossing crossing) : g_(std::move(g)), crossing_(crossing) {}
  template <class S>
  void begin(double t0, const S& y0) {
    before_ = g_(t0, y0);
  }

  /// Cuts the step where g changes its sign.
  template <class Step>
  void cut(Step& step, Status& status) {
    const double first = before_;
    before_ = static_cast<double>(g_(step.end(), step.end_state()));
    if (!counts(first, before_)) return;
    const double t = locate(step, first, before_, status);
    if (status == Status::ok && t < step.end()) status = step.cut_at(t);
    happened_ = true;
  }
  bool happened() const { return happened_; }

 private:
  bool counts(double from, double to) const {
    if (crossing_ != Crossing::falling && from < 0 && to >= 0) return true;
    return crossing_ != Crossing::rising && from > 0 && to <= 0;
  }

  /// The Illinois variant of the rule of false position, with a bisection where it shortens the
  /// bracket by less than half in three evaluations (Dowell, Jarratt, BIT 11 (1971) 168-174). The
  /// result is the end of the bracket on the far side of the event, to the rounding of t.
  template <class Step>
  double locate(Step& step, double g0, double g1, Status& status) {
    double a = step.begin(), b = step.end(), three_ago = b - a;
    int side = 0;
    for (int round = 1; g1 != 0; ++round) {
      const double least =
          4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
      if (b - a <= least) break;
      double t = b - g1 * (b - a) / (g1 - g0);
      if (round % 3 == 0) {
        if (b - a > three_ago / 2) t = a + (b - a) / 2;
        three_ago = b - a;
      }
      t = std::min(std::max(t, a + least / 2), b - least / 2);
      status = step.at(t, step.inner());
      if (status != Status::ok) break;
      const auto g = static_cast<double>(g_(t, std::as_const(step.inner())));
      if (g == 0 || (g > 0) == (g1 > 0)) {
        b = t, g1 = g;
        if (side == 1) g0 /= 2;
        side = 1;
      } else {
        a = t, g0 = g;
        if (side == -1) g1 /= 2;
        side = -1;
      }
    }
    return b;
  }

  G g_;
  Crossing crossing_;
  double before_ = 0;
  bool happened_ = false;
};

/// Ends the run at the first step in which g(t, y) changes its sign, at the time and with the state
/// of the change. A g that is zero where the run begins is not an event; two changes within one
/// step are not seen.
template <class G>
UntilEvent<G> until_event(G g, Crossing crossing = Crossing::any) {
  return UntilEvent<G>(std::move(g), crossing);
}

}  // namespace odeum
