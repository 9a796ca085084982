// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "odeum/control/zeros.hpp"
#include "odeum/core/status.hpp"

/// What may be attached to a run of odeum::integrate: any number of
///
///     each_step(f)                 f(t, y) after each step; returns false to end the run there
///     at_times(times, f)           f(t, y) at each of the ascending times within the run
///     until_event(g, direction)    ends the run at the first zero of g(t, y)
///     at_events(g, f, direction)   f(t, y) at each zero of g(t, y)
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

namespace detail {
/// The zeros of g(t, y) along the steps of a run.
template <class G>
class EventSearch {
 public:
  explicit EventSearch(G g) : g_(std::move(g)) {}
  template <class S>
  void begin(double t0, const S& y0) {
    value_ = static_cast<double>(g_(t0, y0));
    search_.begin();
  }
  /// found(Zero) of each within the step, until it returns true; step.inner() is used.
  template <class Step, class Found>
  void look(Step& step, Status& status, Found&& found) {
    const double first = value_;
    value_ = static_cast<double>(g_(step.end(), step.end_state()));
    const auto g = [&](double t) {
      if (status == Status::ok) status = step.at(t, step.inner());
      return status == Status::ok ? static_cast<double>(g_(t, std::as_const(step.inner())))
                                  : std::numeric_limits<double>::quiet_NaN();
    };
    search_(g, step.begin(), first, step.end(), value_, found);
  }

 private:
  G g_;
  ZeroSearch search_;
  double value_ = 0;
};
}  // namespace detail

template <class G>
class UntilEvent {
 public:
  UntilEvent(G g, Crossing crossing) : search_(std::move(g)), crossing_(crossing) {}
  template <class S>
  void begin(double t0, const S& y0) {
    search_.begin(t0, y0);
  }

  /// Cuts the step at the first zero that counts.
  template <class Step>
  void cut(Step& step, Status& status) {
    double t = step.end();
    search_.look(step, status, [&](const Zero& zero) {
      if (!zero.counts(crossing_)) return false;
      t = zero.t;
      return happened_ = true;
    });
    if (status == Status::ok && t < step.end()) status = step.cut_at(t);
  }
  bool happened() const { return happened_; }

 private:
  detail::EventSearch<G> search_;
  Crossing crossing_;
  bool happened_ = false;
};

/// Ends the run at the first time at which g(t, y) crosses or touches zero, with the state there. A
/// g that is zero where the run begins, to within rounding, is not an event: a run may go on from
/// where another one ended. All zeros within a step are seen (control/zeros.hpp): g is taken in
/// three states within each step at least, each found as Inside in api/between.hpp says.
template <class G>
UntilEvent<G> until_event(G g, Crossing crossing = Crossing::any) {
  return UntilEvent<G>(std::move(g), crossing);
}

template <class G, class F>
class AtEvents {
 public:
  AtEvents(G g, F f, Crossing crossing)
      : search_(std::move(g)), f_(std::move(f)), crossing_(crossing) {}
  template <class S>
  void begin(double t0, const S& y0) {
    search_.begin(t0, y0);
  }
  template <class Step>
  bool report(Step& step, Status& status) {
    search_.look(step, status, [&](const Zero& zero) {
      if (!zero.counts(crossing_)) return false;
      if (status == Status::ok) status = step.at(zero.t, step.inner());
      if (status == Status::ok) f_(zero.t, std::as_const(step.inner()));
      return status != Status::ok;
    });
    return status == Status::ok;
  }

 private:
  detail::EventSearch<G> search_;
  F f_;
  Crossing crossing_;
};

/// At each time at which g(t, y) crosses or touches zero, in their order, `f(t, y)`; the run goes
/// on. They are found as until_event finds the first.
template <class G, class F>
AtEvents<G, F> at_events(G g, F f, Crossing crossing = Crossing::any) {
  return AtEvents<G, F>(std::move(g), std::move(f), crossing);
}

}  // namespace odeum
