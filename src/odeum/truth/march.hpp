// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/truth/along.hpp"
#include "odeum/truth/inspector.hpp"
#include "odeum/truth/sizes.hpp"

namespace odeum::truth {

/// A trial step from (t, y): the new state, its error over the tolerance (of an order), and what
/// the step has cost.
struct Trial {
  State y;
  Real error = 0;
  double work = 0;
};

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
    // To both sides: beyond a jump of f, the difference is not that of rounding.
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

/// By how much a step may change for an error of an order. Double suffices for it, and its power
/// takes a tenth of the time.
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

/// The end of the part of a step from y up to which its conditions hold, just beyond it, and the
/// state there, by shorter steps; nothing where they hold to the end. They are thought to change
/// between two parts of the step.
template <class Step>
std::optional<std::pair<Real, State>> locate_change(const System& system, Real t, Real h,
                                                    const Inside& inside, const State& y,
                                                    const State& sizes, Step&& step, double& work) {
  State end;
  const auto holds_at = [&](Real part) {
    Trial trial = step(t, part, y, sizes);
    work += trial.work;
    end = std::move(trial.y);
    return system.holds(t + part, end.data());
  };
  // Where the path on which the change was found was not accurate it is nearby.
  Real low = h * inside.from, high = h * inside.to, width = high - low;
  Real above = low > 0 ? holds_at(low) : 1, below = holds_at(high);
  while (low > 0 && above <= 0) {
    high = low;
    below = above;
    width *= 2;
    low = std::max<Real>(0, low - width);
    above = low > 0 ? holds_at(low) : 1;
  }
  while (!(below <= 0)) {
    if (high >= h) return std::nullopt;
    width *= 2;
    high = std::min(h, high + width);
    below = holds_at(high);
  }
  holds_at(high);
  State beyond = end;
  const Real enough = 2 * std::numeric_limits<Real>::epsilon() * std::max(std::abs(t), h);
  for (int k = 0; high - low > enough && k < 200; ++k) {
    // The secant, which is weighted where an end stays (Illinois), and halving.
    const Real secant = low + (high - low) * above / (above - below);
    const bool inside_of = k % 3 != 2 && secant > low && secant < high && low > 0;
    const Real part = inside_of ? secant : low + (high - low) / 2;
    if (part <= low || part >= high) break;
    const Real value = holds_at(part);
    if (value <= 0) {
      high = part;
      below = value;
      beyond = end;
      above /= 2;
    } else {
      low = part;
      above = value;
      below /= 2;
    }
  }
  return std::pair{t + high, std::move(beyond)};
}

/// Looks into steps that are accurate enough by their own estimates.
struct Watch {
  Real span = 1;
  std::unique_ptr<Insight> insight;
  Real part = 1;     ///< of a step that does not pass, which is to be tried next
  int shortest = 0;  ///< steps that were hardly longer than is looked into

  /// Whether the step from y to `next` may be taken; else the run has ended, or `part` is set.
  template <class Step>
  bool lets_pass(const System& system, Real t, Real h, const State& y, const State& sizes,
                 const State& next, Step&& step, Run& run) {
    constexpr int most_of_shortest = 2000;
    const Inside inside = insight->look(t, h, y, next);
    if (inside.kind == Inside::Kind::change)
      run.changed = locate_change(system, t, h, inside, y, sizes, step, run.work);
    if (run.changed) return false;
    // A change that is not there was found on a path that is too inaccurate.
    if (inside.kind != Inside::Kind::nothing && h > shortest_inspected * span) {
      run.split = true;
      part = std::clamp(inside.from, 0.25L, 0.75L);
      return false;
    }
    if (h < 8 * shortest_inspected * span && ++shortest > most_of_shortest)
      run.end = fmt::format("the equations are not resolved from t = {:.9Lg} on", t);
    return run.end.empty();
  }
};

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
  const Real span = times.back() - t;
  const Real slope = largest_ratio(f, sizes);
  // At the last of the times, which may be the end itself, and at the one before.
  Real last_slope = size_of(f), earlier_slope = last_slope;
  Real h = std::min(slope > 0 ? 1e-3L / slope : span, span / effort.parts);
  Watch watch{.span = span,
              .insight = effort.inspect && system.insight ? system.insight(span) : nullptr};
  for (const Real time : times) {
    while (t < time) {
      if (interrupted) throw Interrupted();
      const bool late = is_past(effort.until);
      if (late || run.work > effort.budget) {
        run.end = fmt::format("the {} spent at t = {:.6Lg}", late ? "seconds are" : "work is", t);
        return run;
      }
      if (!(h > 4 * std::numeric_limits<Real>::epsilon() * std::abs(t)) || !(h > 1e-300L)) {
        run.end = fmt::format(
            "the steps vanish at t = {:.9Lg}: the solution or the equations end there", t);
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
      if (watch.insight && !watch.lets_pass(system, t, used, y, sizes, trial.y, step, run)) {
        if (run.changed || !run.end.empty()) return run;
        h = used * watch.part;
        continue;
      }
      y = std::move(trial.y);
      measured.update(y);
      if (effort.watched) effort.watched->take(y);
      t = last ? time : t + used;
      const Real next = used * std::clamp(factor, 0.2L, 3.0L);
      h = std::min(last ? std::max(h, next) : next, span / effort.parts);
    }
    run.states.push_back(y);
    if (effort.watched) effort.watched->mark();
    system.rhs(t, y.data(), f.data());
    earlier_slope = std::exchange(last_slope, size_of(f));
  }
  return run;
}

}  // namespace odeum::truth
