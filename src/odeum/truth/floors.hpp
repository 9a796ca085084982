// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <optional>

#include "odeum/core/error_units.hpp"
#include "odeum/truth/families.hpp"
#include "odeum/truth/sizes.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// The factor by which the disagreement of two methods bounds the error of each: it can be small by
/// chance, errors of both can have one sign, and each misses kinks alike.
inline Real safety_of(const System& system) { return system.smooth ? 10 : 100; }

/// What floors are computed from. `moved`: a run on constants that are moved by `moved_by` of
/// themselves; nothing: none was made.
struct FloorsOf {
  const System& system;
  const ErrorUnits& units;
  const std::optional<Run>& moved;
};

inline bool has_moved(const std::optional<Run>& moved, std::size_t k) {
  return moved && k < moved->states.size();
}

/// The error of each component at time k. Rounding of constants is one error with one sign, which
/// two methods share. `apart`, `largest`: up to that time.
inline State floors_of(const FloorsOf& of, const Comparison& best, std::size_t k,
                       const State& apart, const State& largest) {
  constexpr Real least = 0x1p-62L;  // of the scale: rounding of extended precision itself
  const auto unsure = [k](const Run& run, std::size_t i) -> Real {
    return k < run.sure || run.unsure.empty() ? 0 : run.unsure[i];
  };
  const bool in_double = of.system.events && of.system.events->in_double;
  const State& y = best.a.states[k];
  State constants(y.size(), in_double ? HUGE_VALL : 0), floors(y.size());
  if (has_moved(of.moved, k)) constants = difference_of(y, of.moved->states[k]);
  for (std::size_t i = 0; i < y.size(); ++i)
    floors[i] = safety_of(of.system) * apart[i] +
                10 * constants[i] / moved_by * (in_double ? 0x1p-54L : 0x1p-64L) +
                unsure(best.a, i) + unsure(best.b, i) +
                least * (of.units.is_relative(i) ? std::abs(y[i]) : largest[i]);
  return floors;
}

/// Whether moved constants have another number of events before time k, of times since the start.
inline bool constants_decide_events(const std::optional<Run>& moved, const Comparison& best,
                                    const State& elapsed, std::size_t k) {
  const Real sure = elapsed[k] - 0x1p-36L * elapsed.back();  // moved times are off by 2^-40
  return has_moved(moved, k) && moved->events_before(sure) != best.a.events_before(sure);
}

}  // namespace odeum::truth
