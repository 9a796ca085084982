// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "odeum/truth/inspector.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// A trial step from (t, y): the new state, its error divided by the tolerance, and the operations
/// spent.
struct Trial {
  State y;
  Real error = 0;
  double work = 0;
};

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
  Real span = 1;  ///< of the whole run
  std::unique_ptr<Insight> insight;
  bool changes_only = false;  ///< pulses that samples may have missed are let pass
  Real part = 1;              ///< of a step that does not pass, which is to be tried next
  int shortest = 0;           ///< steps that were hardly longer than is looked into

  /// Whether the step from y to `next` may be taken; else the run has ended, or `part` is set.
  template <class Step>
  bool lets_pass(const System& system, Real t, Real h, const State& y, const State& sizes,
                 const State& next, Step&& step, Run& run) {
    constexpr int most_of_shortest = 2000;
    const Inside inside = insight->look(t, h, y, next);
    if (inside.kind == Inside::Kind::change)
      run.changed = locate_change(system, t, h, inside, y, sizes, step, run.work);
    if (run.changed) return false;
    if (changes_only && inside.kind != Inside::Kind::change) return true;
    // A change that is not there was found on a path that is too inaccurate.
    if (inside.kind != Inside::Kind::nothing && h > shortest_inspected * span) {
      run.split = true;
      part = std::clamp(inside.from, 0.25L, 0.75L);
      return false;
    }
    if (h < 8 * shortest_inspected * span && ++shortest > most_of_shortest)
      run.end =
          fmt::format("the equations are not resolved from t = {:.9Lg} on", system.origin + t);
    else if (inside.kind != Inside::Kind::nothing && !is_harmless(t, h, y, sizes, next, run))
      run.end = fmt::format("the equations have something shorter than {:.1Lg} at t = {:.9Lg}", h,
                            system.origin + t);
    return run.end.empty();
  }

 private:
  /// Whether the unseen part of a step that can't be looked into moves the state by little.
  bool is_harmless(Real t, Real h, const State& y, const State& sizes, const State& next,
                   Run& run) {
    constexpr Real little = 1e-9L;  // of the largest state
    const State spread = insight->spread(t, h, y, next);
    const Real size = *std::ranges::max_element(sizes);
    if (run.unsure.empty()) run.sure = run.states.size();
    run.unsure.resize(y.size());
    bool harmless = true;
    for (std::size_t i = 0; i < y.size(); ++i) {
      run.unsure[i] += h * spread[i];
      harmless = harmless && run.unsure[i] <= little * (size > 0 ? size : 1);
    }
    return harmless;
  }
};

}  // namespace odeum::truth
