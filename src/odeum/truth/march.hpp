// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// A trial step from (t, y): the new state, its error over the tolerance (of an order), and what
/// the step has cost.
struct Trial {
  State y;
  Real error = 0;
  double work = 0;
};

/// The size of each component so far, by which errors are measured: a component that passes through
/// zero has no relative error. One that has always been small is measured with the largest, but not
/// by less than 1e-6 of that. `memory`: what remains of an earlier size after a step, down to 1e-4
/// of the component's largest, `peaks`.
inline void update_running_maxima(State& sizes, State& peaks, const State& y, Real memory) {
  Real largest = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    peaks[i] = std::max(peaks[i], std::abs(y[i]));
    sizes[i] = std::max({memory * sizes[i], std::abs(y[i]), 1e-4L * peaks[i]});
    largest = std::max(largest, sizes[i]);
  }
  for (Real& size : sizes) size = std::max(size, 1e-6L * largest);
}

inline Real size_of(const State& y) {
  Real largest = 0;
  for (const Real x : y) largest = std::max(largest, std::abs(x));
  return largest;
}

inline Real largest_ratio(const State& error, const State& sizes) {
  Real worst = 0;
  for (std::size_t i = 0; i < error.size(); ++i) {
    const Real ratio = sizes[i] > 0 ? std::abs(error[i]) / sizes[i] : std::abs(error[i]);
    if (std::isnan(ratio)) return ratio;
    worst = std::max(worst, ratio);
  }
  return worst;
}

/// What rounding of y moves f by, by component: no method at a step of h has an error below h times
/// that, and none is asked for it.
class Noise {
 public:
  explicit Noise(const System& system)
      : system_(system), f_(system.states), moved_(f_), above_(f_), below_(f_) {}

  /// The largest component of the error over the tolerance.
  Real ratio(Real t, Real h, const State& y, const State& error, const State& sizes,
             Real tolerance) {
    // The weights of the methods' estimates amplify it.
    constexpr Real amplified = 16;
    const Real unit = system_.rounding, relative = 0x1p11L * unit;
    system_.rhs(t, y.data(), f_.data());
    // To both sides: beyond a jump of f, the difference is not that of rounding.
    for (std::size_t i = 0; i < y.size(); ++i) moved_[i] = y[i] * (1 + relative);
    system_.rhs(t, moved_.data(), above_.data());
    for (std::size_t i = 0; i < y.size(); ++i) moved_[i] = y[i] * (1 - relative);
    system_.rhs(t, moved_.data(), below_.data());
    Real worst = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const Real moves = std::min(std::abs(above_[i] - f_[i]), std::abs(below_[i] - f_[i]));
      const Real noise = moves * (unit / relative) + unit * std::abs(f_[i]);
      const Real allowed = tolerance * (sizes[i] > 0 ? sizes[i] : 1) + amplified * h * noise;
      const Real part = std::abs(error[i]) / allowed;
      if (std::isnan(part)) return part;
      worst = std::max(worst, part);
    }
    return worst;
  }

 private:
  const System& system_;
  State f_, moved_, above_, below_;
};

/// By how much a step may change for an error of an order. Double suffices for it, and its power
/// takes a tenth of the time.
inline Real step_factor(Real error, int order) {
  if (!std::isfinite(error)) return 0.25L;
  if (error == 0) return 4;
  const auto bounded = static_cast<double>(std::clamp(error, 1e-300L, 1e300L));
  return 0.9 * std::pow(bounded, -1.0 / order);
}

/// After a peak, as of a relaxation's speed, an error of its size would be one of all digits of
/// what follows: it is forgotten after some thousand steps, which are more than a period of an
/// oscillation takes. Methods that know the noise of f are not asked for less than that.
constexpr Real short_memory = 0.999L;

/// Steps through the times with `step(t, h, y, sizes) -> Trial`, whose error is of order `order` in
/// h and relative to the tolerance.
template <class Step>
Run march(const System& system, const std::vector<Real>& times, const Effort& effort, int order,
          Step&& step, Real memory = 1) {
  Run run;
  State y = system.y0, sizes(y.size(), 0), peaks(sizes), f(y.size());
  update_running_maxima(sizes, peaks, y, memory);
  system.rhs(system.t0, y.data(), f.data());
  Real t = system.t0;
  const Real span = times.back() - t;
  const Real slope = largest_ratio(f, sizes);
  // At the last of the times, which may be the end itself, and at the one before.
  Real last_slope = size_of(f), earlier_slope = last_slope;
  Real h = std::min(slope > 0 ? 1e-3L / slope : span, span / 50);
  for (const Real time : times) {
    while (t < time) {
      if (interrupted) throw Interrupted();
      if (run.work > effort.budget) {
        run.end = fmt::format("the work is spent at t = {:.6Lg}", t);
        return run;
      }
      if (!(h > 4 * std::numeric_limits<Real>::epsilon() * std::abs(t)) || !(h > 1e-300L)) {
        run.end = fmt::format(
            "the steps vanish at t = {:.9Lg}: the solution or the equations end "
            "there",
            t);
        system.rhs(t, y.data(), f.data());
        // At a kink, where steps vanish too, it is bounded.
        constexpr Real unbounded = 1e6L;
        if (!(size_of(f) <= unbounded * std::min(last_slope, earlier_slope))) run.ends_at = t;
        return run;
      }
      const bool last = t + h * (1 + 1e-6L) >= time;
      const Real used = last ? time - t : h;
      Trial trial = step(t, used, y, sizes);
      run.work += trial.work;
      const Real factor = step_factor(trial.error, order);
      if (!std::isfinite(trial.error) || trial.error > 1) {
        h = used * std::clamp(factor, 0.1L, 0.7L);
        continue;
      }
      y = std::move(trial.y);
      update_running_maxima(sizes, peaks, y, memory);
      t = last ? time : t + used;
      const Real next = used * std::clamp(factor, 0.2L, 3.0L);
      h = std::min(last ? std::max(h, next) : next, span / 50);
    }
    run.states.push_back(y);
    system.rhs(t, y.data(), f.data());
    earlier_slope = std::exchange(last_slope, size_of(f));
  }
  return run;
}

}  // namespace odeum::truth
