// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <utility>

#include "odeum/control/inner_kinks.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/kernel/scaled_norm.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// The range of each component of f over the evaluations of a trial step, and whether f at the ends
/// of the step is in it. A method that evaluates f at neither end sees nothing of a jump between an
/// end and the stage next to it: its estimate is that of a smooth problem, and the step is lost. On
/// a smooth problem f at the ends is within the range of the stages, or beyond it by no more than a
/// few times its width.
template <Ode P>
class SlopeRange {
 public:
  /// `looks_inside`: for jumps and kinks between the evaluations, too, see InnerKinks.
  /// `sees_ends`: the method evaluates f at both ends, the start in the step before.
  SlopeRange(const P& problem, bool looks_inside, bool sees_ends)
      : problem_(problem),
        looks_inside_(looks_inside),
        sees_ends_(sees_ends),
        low_(make_state(problem)),
        high_(low_),
        f_(low_),
        y_(low_),
        beyond_(low_) {}

  /// Before a trial step.
  void begin() {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (double& each : low_) each = infinite;
    for (double& each : high_) each = -infinite;
    inner_.begin();
  }
  /// After a trial step of h from (t, y) to y_new that is about to be accepted. `damp(x)`: what the
  /// method makes of a change of h f by x, since f multiplies the errors of stiff components.
  template <class Damp>
  bool has_ends(double t, double h, const State<P>& y, const State<P>& y_new,
                const ErrorScale<State<P>>& scale, Damp&& damp) {
    if (sees_ends_) {
      if (inner_.matters(h, y_new, scale, damp)) return false;
      inner_.keep_end();
      return true;
    }
    if (!(t == t_ && y == y_)) problem_.rhs(t, y.data(), f_.data());
    note(t);
    if (!has(h, y, scale, damp)) return false;
    problem_.rhs(t + h, y_new.data(), f_.data());
    note(t + h);
    t_ = t + h;
    y_ = y_new;
    if (has(h, y_new, scale, damp) && !(looks_inside_ && inner_.matters(h, y_new, scale, damp)))
      return true;
    t_ = std::numeric_limits<double>::quiet_NaN();
    return false;
  }

  // The watch of Guarded.
  template <class Size, class Call>
  int evaluate(double t, const double* values, Size&& size, bool second_half, Call&& call,
               int = 1) {
    call();
    const std::size_t n = size(), first = second_half ? n : 0;
    if (looks_inside_) inner_.note(t, values, n, first, f_.size());
    for (std::size_t i = 0; i < n; ++i) {
      low_[first + i] = std::min(low_[first + i], values[i]);
      high_[first + i] = std::max(high_[first + i], values[i]);
    }
    return tripped();
  }
  static constexpr void count_jacobian() {}
  static constexpr void count_products(std::uint64_t) {}
  bool tripped() const {
    if constexpr (requires { problem_.tripped(); }) return problem_.tripped();
    return false;
  }

 private:
  void note(double t) {
    if (looks_inside_) inner_.note(t, f_.data(), f_.size(), 0, f_.size());
  }
  /// Whether f_ is in the range, or near enough to it not to matter: what lies between an end and
  /// a stage is at most half of the step.
  template <class Damp>
  bool has(double h, const State<P>& y, const ErrorScale<State<P>>& scale, Damp&& damp) {
    constexpr double matters = 10;  // times the tolerance
    constexpr double widths =
        3;  // the evaluations of seulex may see a third of what f goes through
    bool in_range = true;
    for (std::size_t i = 0; i < f_.size(); ++i) {
      const double wide = widths * (high_[i] - low_[i]);  // negative where none had the component
      const double above = f_[i] - high_[i] - wide, below = low_[i] - f_[i] - wide;
      beyond_[i] = wide >= 0 ? h * (std::max(above, 0.0) - std::max(below, 0.0)) : 0;
      in_range = in_range && std::abs(beyond_[i]) <= matters * scale(i, std::abs(y[i]));
    }
    if (in_range) return true;
    damp(beyond_);
    for (std::size_t i = 0; i < f_.size(); ++i)
      if (std::abs(beyond_[i]) > matters * scale(i, std::abs(y[i]))) return false;
    return true;
  }

  const P& problem_;
  bool looks_inside_, sees_ends_;
  InnerKinks<P> inner_;
  State<P> low_, high_, f_, y_, beyond_;
  double t_ = std::numeric_limits<double>::quiet_NaN();  ///< of f_ and y_
};

template <class P>
std::unique_ptr<ShiftedSolver> counted(std::unique_ptr<ShiftedSolver> solver,
                                       const SlopeRange<P>&) {
  return solver;
}

/// A problem whose slopes are watched. Otherwise it is the problem itself, whose guard has the
/// weights of differences and counts Jacobians.
template <Ode P>
class InRange : public Guarded<P, SlopeRange<P>&> {
 public:
  InRange(const P& problem, SlopeRange<P>& range)
      : Guarded<P, SlopeRange<P>&>(problem, range), problem_(problem), range_(range) {}
  template <class Q = P>
  auto watch() const -> decltype(std::declval<const Q&>().watch()) {
    return problem_.watch();
  }
  SlopeRange<P>& range() const { return range_; }

 private:
  const P& problem_;
  SlopeRange<P>& range_;
};

/// What trial steps call before and after a trial; nothing but on a problem with such a watch.
template <class P>
void begin_trial(const P& problem) {
  if constexpr (requires { problem.range(); }) problem.range().begin();
}
template <class P, class Stepper>
bool has_ends(const P& problem, double t, double h, const State<P>& y, const State<P>& y_new,
              const ErrorScale<State<P>>& scale, [[maybe_unused]] Stepper& stepper) {
  if constexpr (requires { problem.range(); })
    return problem.range().has_ends(t, h, y, y_new, scale, [&](State<P>& x) {
      if constexpr (requires { stepper.damp(x); }) stepper.damp(x);
    });
  return true;
}

}  // namespace odeum
