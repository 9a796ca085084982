// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/truth/along.hpp"
#include "odeum/truth/ending.hpp"
#include "odeum/truth/sizes.hpp"
#include "odeum/truth/watch.hpp"

namespace odeum::truth {

/// What rounding of y moves f by, by component: no method at a step of h has an error below h times
/// that, and none is asked for it.
class Noise {
 public:
  explicit Noise(const System& system)
      : system_(system), f_(system.states), moved_(f_), above_(f_), below_(f_), rounding_(f_) {}

  /// The largest component of the error over the tolerance.
  Real ratio(Real t, Real h, const State& y, const State& error, const State& sizes,
             Real tolerance) {
    // The weights of the methods' estimates amplify it.
    constexpr Real amplified = 16;
    const Real unit = system_.rounding, relative = 0x1p11L * unit;
    system_.rhs(t, y.data(), f_.data());
    // Both sides are looked at: beyond a jump of f, the difference is not that of rounding.
    for (std::size_t i = 0; i < y.size(); ++i) moved_[i] = y[i] * (1 + relative);
    system_.rhs(t, moved_.data(), above_.data());
    for (std::size_t i = 0; i < y.size(); ++i) moved_[i] = y[i] * (1 - relative);
    system_.rhs(t, moved_.data(), below_.data());
    const auto worst_part = [&] {
      Real worst = 0;
      for (std::size_t i = 0; i < y.size(); ++i) {
        const Real moves = std::min(std::abs(above_[i] - f_[i]), std::abs(below_[i] - f_[i]));
        const Real noise = moves * (unit / relative) + unit * std::abs(f_[i]) + rounding_[i];
        const Real allowed = tolerance * (sizes[i] > 0 ? sizes[i] : 1) + amplified * h * noise;
        const Real part = std::abs(error[i]) / allowed;
        if (std::isnan(part)) return part;
        worst = std::max(worst, part);
      }
      return worst;
    };
    std::ranges::fill(rounding_, 0);
    const Real worst = worst_part();
    if (!(worst > 1) || !system_.insight) return worst;
    // What cancels inside of f leaves a rounding that neither f nor y tells.
    if (!insight_) insight_ = system_.insight(1);
    return insight_->rounding(t, y, rounding_) ? worst_part() : worst;
  }

 private:
  const System& system_;
  State f_, moved_, above_, below_, rounding_;
  std::unique_ptr<Insight> insight_;
};

/// Fills a row of an extrapolation table by Neville's scheme: `line`, its first entry, becomes its
/// last, and `difference` by how much the last two differ. table[k] has the entries of the row
/// above and gets those of this one.
template <std::size_t rows, class Weight>
void extrapolate(std::array<State, rows>& table, int row, State& line, State& difference,
                 const Weight& weight_of) {
  for (int k = 0; k < row; ++k) {
    const Real weight = weight_of(k);
    State& above = table[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Real left = line[i];
      difference[i] = weight * (left - above[i]);
      above[i] = left;
      line[i] = left + difference[i];
    }
  }
  table[static_cast<std::size_t>(row)] = line;
}

/// The factor by which a step may change for an error of an order. Double suffices for it, and its
/// power takes a tenth of the time.
inline Real step_factor(Real error, int order) {
  if (!std::isfinite(error)) return 0.25L;
  if (error == 0) return 4;
  const auto bounded = static_cast<double>(std::clamp(error, 1e-300L, 1e300L));
  return 0.9 * std::pow(bounded, -1.0 / order);
}

/// Errors are measured against a running maximum that decays by this factor a step. Without decay a
/// large early peak, as of a relaxation's speed, would hide the loss of all digits later. A maximum
/// lasts for some thousand steps, more than a period of an oscillation takes. Methods that know the
/// noise of f are not asked for errors below that noise.
constexpr Real short_memory = 0.999L;

/// What a start at zero comes to in h, at most 1, or the largest where that is known. `f`: the
/// slope at the start.
inline Real size_soon(const System& system, Real h, State y, State f) {
  const Real size = size_of(f);
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = h * f[i];
  system.rhs(system.t0 + h, y.data(), f.data());
  const Real later = size_of(f);
  const Real most = system.along ? *std::ranges::max_element(system.along->largest) : 1;
  return std::min(h * (std::isfinite(later) ? std::max(size, later) : size), most);
}

/// The measured cost of allocations, and of the inspector's intervals, in operations.
inline double overhead_of_step(const System& system, std::size_t states, bool is_inspected) {
  return 200 + 20 * static_cast<double>(states) + (is_inspected ? 400 + 40 * system.work : 0);
}

/// Says that the seconds or the work of a run are spent; empty while they are not.
inline std::string words_of_limit(const Effort& effort, double work, Real t) {
  const bool late = is_past(effort.until);
  if (!late && work <= effort.budget) return {};
  return fmt::format("the {} spent at t = {:.6Lg}", late ? "seconds are" : "work is", t);
}

inline std::string words_of_vanishing(bool ends, Real t) {
  return fmt::format("the steps vanish at t = {:.9Lg}: {}", t,
                     ends ? "the solution or the equations end there"
                          : "the equations end there, or have something that is shorter than "
                            "steps can be");
}

/// A slope may be far larger than what the solution comes to, and no step is below the rounding of
/// t: such a step is tried.
inline Real first_step(Real slope, Real t, Real span, Real parts) {
  const Real shortest = 64 * std::numeric_limits<Real>::epsilon() * std::abs(t);
  return std::min(std::max(slope > 0 ? 1e-3L / slope : span, shortest), span / parts);
}

/// Disturbs a state, and raises smaller components than are asked for, but no zero, which has no
/// sign.
inline void alter(const Effort& effort, Disturbance& disturbance, State& y) {
  if (effort.disturb) disturbance.move(y);
  for (std::size_t i = 0; effort.at_least && i < y.size(); ++i)
    if (y[i] != 0) y[i] = std::copysign(std::max(std::abs(y[i]), (*effort.at_least)[i]), y[i]);
}

/// Steps through the times with `step(t, h, y, sizes) -> Trial`, whose error is of order `order` in
/// h and relative to the tolerance.
template <class Step>
Run march(const System& system, const std::vector<Real>& times, const Effort& effort, int order,
          Step&& step, Real memory = 1) {
  Run run;
  State y = system.y0, f(y.size());
  Sizes measured(system, y, effort.least_part, memory);
  const State& sizes = measured.now;
  if (effort.watched) effort.watched->take(y);
  system.rhs(system.t0, y.data(), f.data());
  Real t = system.t0;
  const Real span = effort.span > 0 ? effort.span : times.back() - t;
  // The slope tells the size of a start at zero, for one step.
  if (measured.none_yet()) measured.expect(size_soon(system, span * 0x1p-20L, y, f));
  Real h = first_step(largest_ratio(f, sizes), t, span, effort.parts);
  Watch watch{.span = span,
              .insight = effort.inspect && system.insight ? system.insight(span) : nullptr,
              .changes_only = effort.watched != nullptr};
  Ending ending;
  Disturbance disturbance;
  const double overhead = overhead_of_step(system, y.size(), watch.insight != nullptr);
  for (const Real time : times) {
    while (t < time) {
      if (interrupted) throw Interrupted();
      if (run.end = words_of_limit(effort, run.work, system.origin + t); !run.end.empty())
        return run;
      const Real unit = std::numeric_limits<Real>::epsilon() * std::abs(t);
      if (!(h > 4 * unit) || !(h > 1e-300L)) {
        if (ending.is_of_solution(system, t, y, unit)) run.ends_at = t;
        run.end = words_of_vanishing(std::isfinite(run.ends_at), system.origin + t);
        return run;
      }
      const bool last = t + h * (1 + 1e-6L) >= time;
      const Real used = last ? time - t : h;
      Trial trial = step(t, used, y, sizes);
      run.work += trial.work + overhead;
      const Real factor = step_factor(trial.error, order);
      if (!std::isfinite(trial.error) || trial.error > 1) {
        h = used * std::clamp(factor, 0.1L, 0.7L);
        continue;
      }
      if (watch.insight && !watch.lets_pass(system, t, used, y, sizes, trial.y, step, run)) {
        run.peaks = measured.peaks();
        if (run.changed || !run.end.empty()) return run;
        h = used * watch.part;
        continue;
      }
      ending.add(t, y);
      y = std::move(trial.y);
      alter(effort, disturbance, y);
      measured.update(y);
      if (effort.watched) effort.watched->take(y);
      t = last ? time : t + used;
      run.reached = t;
      const Real next = used * std::clamp(factor, 0.2L, 3.0L);
      h = std::min(last ? std::max(h, next) : next, span / effort.parts);
    }
    run.states.push_back(y);
    if (effort.watched) effort.watched->mark();
  }
  run.peaks = measured.peaks();
  return run;
}

}  // namespace odeum::truth
