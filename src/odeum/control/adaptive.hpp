// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <type_traits>
#include <utility>

#include "odeum/core/outcome.hpp"
#include "odeum/core/request.hpp"
#include "odeum/core/text_of.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/scaled_norm.hpp"
#include "odeum/problem/concepts.hpp"

/// The adaptive loop, and the interface of what chooses its steps. A `Trial` makes one trial step
/// of length h from (t, y), and accepts it, with the new state in y_new, or rejects it:
///
///     Decision operator()(double t, double h, const State<P>& y, State<P>& y_new);
///
/// It may offer besides
///
///     double longest_step(double t, const State<P>& y);   // known before the trial: replaces the
///                                                         // step that was decided on before
///     Status between(const StepMade<State<P>>& step, double t, State<P>& y);
///                                                         // the state inside the step accepted
///                                                         // last, at the order of the method;
///                                                         // not ok: at a lower order
///     void moved();                                       // the state at the end of the step
///                                                         // accepted last was changed
///
/// The loop then steps over all stops but the last where the request asks for it (over_stops), and
/// always under a trial that says so (`static constexpr bool always_over_stops`). Without an
/// interpolant of its order a method makes a step aside, from the start of the step made to the
/// stop: more evaluations, but the same steps and values whatever the stops are.
///
/// One-step methods (one_step.hpp) leave the decision to a controller of step_control.hpp; methods
/// that choose their order as well (extrapolation, BDF) decide themselves.
namespace odeum {

/// After a trial step of h: `next_step` is the length of the repetition or of the following step.
struct Decision {
  bool accept;
  double next_step;
};

/// The step accepted last: from t to t + h, and the states at its ends.
template <class S>
struct StepMade {
  double t, h;
  const S &before, &after;
  /// The share of the step at a time, 0 to 1.
  double share(double time) const { return (time - t) / h; }
  /// On the straight line between its ends, for where nothing better is known.
  void by_line(double time, S& y) const {
    const double at = share(time);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = before[i] + at * (after[i] - before[i]);
  }
};

/// The mean over the components of (e_i / (abs_i + rel max(|y_i|, |y_new_i|)))^2: 1 at the
/// tolerance (Hairer, Norsett, Wanner, Solving ODEs I, (II.4.10)-(II.4.11)); not finite where y_new
/// is not. Always inlined: timed units round it in their own way.
template <class S>
[[gnu::always_inline]] inline auto scaled_error_square(const S& error, const S& y, const S& y_new,
                                                       const ErrorScale<S>& error_scale) {
  using std::abs, std::max;
  const auto sum = sum_of_components(
      y, [&](std::size_t i) __attribute__((always_inline)) {
        const auto scale = error_scale(i, max(abs(y[i]), abs(y_new[i])));
        const auto scaled = error[i] * (1 / scale);
        return scaled * scaled + 0 * y_new[i];
      });
  return sum * (1 / static_cast<double>(y.size()));
}
template <class S>
[[gnu::always_inline]] inline double scaled_error_norm(const S& error, const S& y, const S& y_new,
                                                       const ErrorScale<S>& error_scale) {
  return std::sqrt(scaled_error_square(error, y, y_new, error_scale));
}

/// A first step for a method of the given order (Solving ODEs I, II.4, "Starting step size").
template <Ode P>
double initial_step(const P& problem, double t0, const State<P>& y0, double horizon, int order,
                    const Tolerance& tolerance) {
  const ErrorScale<State<P>> scale(tolerance, y0);
  State<P> f0 = make_state(problem), y1 = f0, f1 = f0;
  problem.rhs(t0, y0.data(), f0.data());
  const double d0 = scaled_error_norm(y0, y0, y0, scale);
  const double d1 = scaled_error_norm(f0, y0, y0, scale);
  const double h0 = std::min(d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * d0 / d1, horizon - t0);
  for (std::size_t i = 0; i < y0.size(); ++i) y1[i] = y0[i] + h0 * f0[i];
  problem.rhs(t0 + h0, y1.data(), f1.data());
  for (std::size_t i = 0; i < y0.size(); ++i) f1[i] -= f0[i];
  const double d2 = scaled_error_norm(f1, y0, y0, scale) / h0;
  const double steepest = std::max(d1, d2);
  const double h1 = steepest > 1e-15 && std::isfinite(steepest)
                        ? std::pow(0.01 / steepest, 1.0 / (order + 1))
                        : std::max(1e-6, h0 * 1e-3);
  return std::min({100 * h0, h1, horizon - t0});
}

/// The trial steps of a run and the length of the first.
template <class Trial>
struct TrialSteps {
  double first_step;
  Trial trial;
};
template <class Trial>
TrialSteps(double, Trial) -> TrialSteps<Trial>;

/// How one trial step of an AdaptiveWalk ended.
enum class Trialled { accepted, rejected, tripped, too_small };

/// The time of an adaptive run and the length of the step to come.
class StepClock {
 public:
  // The first step is a guess, and no failure where it is shorter than t resolves.
  StepClock(double t0, double first_step)
      : t_(t0), h_(std::max(first_step, 2 * rounding * std::abs(t0))), t_made_(t0) {}

  /// Begins a trial step, shortened where it would end beyond `target`; false where it is at the
  /// rounding of t. That is relative to t, not to the horizon: near t = 0 a first step may be very
  /// short.
  bool begin(double target) {
    if (!(h_ >= std::max(rounding * std::abs(t_), std::numeric_limits<double>::min())))
      return false;
    last_ = t_ + h_ >= target - rounding * std::abs(target);
    used_ = last_ ? target - t_ : h_;
    target_ = target;
    return true;
  }
  /// Ends it by a decision; returns whether it was accepted.
  bool end(const Decision& decision) {
    if (!decision.accept) {
      h_ = decision.next_step;
      return false;
    }
    t_made_ = t_;
    h_made_ = used_;
    t_ = last_ ? target_ : t_ + used_;
    // A step shortened to meet a stop does not limit the next one.
    h_ = last_ ? std::max(h_, decision.next_step) : decision.next_step;
    return true;
  }

  double t() const { return t_; }
  double h() const { return h_; }        ///< the step to come
  void set(double h) { h_ = h; }         ///< the same
  double used() const { return used_; }  ///< the length of the trial step
  double t_made() const { return t_made_; }
  double h_made() const { return h_made_; }  ///< of the step accepted last

 private:
  static constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
  double t_, h_, t_made_, h_made_ = 0, used_ = 0, target_ = 0;
  bool last_ = false;
};

/// The adaptive loop, one trial step at a time: t, the state and the step to come. `P` is what the
/// solver sees, with `tripped()` where it may end a run.
template <class P, class Trial>
class AdaptiveWalk {
 public:
  AdaptiveWalk(const P& problem, double t0, const State<P>& y0, double first_step, Trial& trial)
      : problem_(problem), trial_(trial), clock_(t0, first_step), y_(y0), y_new_(y0) {}

  /// One trial step, shortened where it would end beyond `target`. Where it is accepted, t() and
  /// y() have moved and before() is the state before; `tripped` leaves all as it was.
  Trialled attempt(double target) {
    if constexpr (requires { trial_.longest_step(t(), y_); })
      clock_.set(trial_.longest_step(t(), y_));
    if (!clock_.begin(target)) return Trialled::too_small;
    const Decision decision = trial_(t(), clock_.used(), y_, y_new_);
    if constexpr (requires { problem_.tripped(); })
      if (problem_.tripped()) return Trialled::tripped;
    if (!clock_.end(decision)) return Trialled::rejected;
    exchange_components(y_, y_new_);
    return Trialled::accepted;
  }

  /// Moves the state onto the problem's constraints; false where that fails.
  bool project() requires(WithProjection<P>) {
    const bool found = problem_.project(t(), y_.data()) > 0;
    if constexpr (requires { trial_.moved(); }) trial_.moved();
    return found;
  }

  double t() const { return clock_.t(); }
  double h() const { return clock_.h(); }  ///< the step to come
  const State<P>& y() const { return y_; }
  const State<P>& before() const { return y_new_; }  ///< the last accepted step began here
  StepMade<State<P>> made() const { return {clock_.t_made(), clock_.h_made(), y_new_, y_}; }

 private:
  const P& problem_;
  Trial& trial_;
  StepClock clock_;
  State<P> y_, y_new_;
};

/// The state at a time inside the step made by a step aside, `step(t, h, y)` from its start, which
/// returns whether its equations were solved: by one, else 2, 4, ..., else on a line.
template <class S, class Step>
Status step_aside(const StepMade<S>& made, double time, S& y, Step&& step) {
  for (int parts = 1; parts <= 1024; parts *= 2) {
    const double h = (time - made.t) / parts;
    y = made.before;
    int k = 0;
    while (k < parts && step(made.t + k * h, h, y)) ++k;
    if (k == parts) return Status::ok;
  }
  made.by_line(time, y);
  return Status::newton_failed;
}

template <class Trial, class S>
concept LooksBetween = requires(Trial trial, const StepMade<S>& step, double t, S& y) {
  { trial.between(step, t, y) } -> std::same_as<Status>;
};

template <class Trial>
constexpr bool always_over_stops(const Trial&) {
  if constexpr (requires { Trial::always_over_stops; }) return Trial::always_over_stops;
  return false;
}

/// Ends a run whose state was not moved onto the constraints at t.
inline Outcome& not_projected(Outcome& outcome, double t) {
  outcome.status = Status::newton_failed;
  outcome.t = t;
  outcome.detail = "no state on the constraints was found near that of t = " + text_of(t);
  return outcome;
}

/// Steps from t0 to the last stop; they are shortened only to end on a stop.
template <Ode P, class Trial>
Outcome run_adaptive(const P& problem, double t0, const State<P>& y0, const Request& request,
                     double first_step, Trial&& trial) {
  constexpr bool looks_between = LooksBetween<std::remove_cvref_t<Trial>, State<P>>;
  const bool over = looks_between && (request.over_stops || always_over_stops(trial));
  Outcome outcome;
  AdaptiveWalk<P, std::remove_reference_t<Trial>> walk(problem, t0, y0, first_step, trial);
  State<P> y_between = y0;
  for (const double stop : request.stops) {
    while (walk.t() < stop) {
      outcome.t = walk.t();
      switch (walk.attempt(over ? request.stops.back() : stop)) {
        case Trialled::too_small:
          outcome.status = Status::step_too_small;
          outcome.detail = "step " + text_of(walk.h()) + " at t = " + text_of(walk.t()) +
                           " is at the rounding of t";
          return outcome;
        case Trialled::tripped:
          return outcome;  // the guard has the reason
        case Trialled::accepted:
          ++outcome.counters.steps;
          if (request.record_steps) outcome.step_ends.push_back(walk.t());
          if constexpr (WithProjection<P>)
            if (offers_project(problem) && !walk.project()) return not_projected(outcome, walk.t());
          break;
        case Trialled::rejected:
          ++outcome.counters.rejected_steps;
      }
    }
    const bool beyond = walk.t() > stop;
    if constexpr (looks_between)
      if (beyond) {
        // An output that fails is not a failure of the run.
        const Status found = trial.between(walk.made(), stop, y_between);
        if (problem.tripped()) return outcome;
        if (found != Status::ok && outcome.detail.empty())
          outcome.detail = "the state at t = " + text_of(stop) + " is interpolated, " +
                           to_string(found) + " between the steps";
      }
    const State<P>& at_stop = beyond ? y_between : walk.y();
    outcome.record(stop, at_stop.data(), at_stop.size());
  }
  return outcome;
}

}  // namespace odeum
