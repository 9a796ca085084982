// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "odeum/core/clocks.hpp"
#include "odeum/truth/sizes.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {

/// Two methods that share no formula.
struct Family {
  Method first, second;
  const char* words;
  Method for_moved;            ///< the cheaper one of those without a series
  Real finest;                 ///< tolerance below which `second` does the same
  std::array<Real, 2> orders;  ///< work grows as the tolerance to -1 / order
};

/// Two runs and how they differ.
struct Comparison {
  Run a, b;
  bool spent = false;        ///< one of them ended for the work that it took
  std::vector<State> apart;  ///< by time and component, as far as both came
  Real worst = 0;            ///< of those that are known
  std::size_t known = 0;     ///< times at which they agree
};
inline bool is_better(const Comparison& a, const Comparison& b) {
  return a.known > b.known || (a.known == b.known && a.worst < b.worst);
}

/// Compares the states of two runs up to the time from which on they agree on nothing.
inline void compare_states(const State& y0, const ErrorUnits& units, Comparison& c) {
  constexpr Real unknown = 1e-6L;  // of the scale: beyond that nothing is known
  const std::size_t both = std::min(c.a.states.size(), c.b.states.size());
  Real size = largest_of(y0, y0, units);
  while (c.known < both) {
    const State& y = c.a.states[c.known];
    State apart = difference_of(y, c.b.states[c.known]);
    const Real d = largest_of(apart, y, units);
    size = std::max(size, largest_of(y, y, units));
    if (!(d <= unknown * size)) break;
    c.worst = std::max(c.worst, d);
    c.apart.push_back(std::move(apart));
    ++c.known;
  }
}

/// Seconds of the processor for a search; unoptimised and sanitized programs take many times as
/// long.
inline double seconds_for(std::size_t states) {
#ifdef NDEBUG
  constexpr double times = 1;
#else
  constexpr double times = 20;
#endif
  return times * (states > 10 ? 20 : 5);
}

/// A run of at most so many of the seconds of the processor that a search was given.
inline Run run_within(double part, double seconds, Method method, const System& system,
                      const std::vector<Real>& times, Effort effort, bool moved) {
  const double start = processor_seconds();
  effort.busy_until = start + part;
  effort.seconds = seconds;
  Run run = run_across(method, system, times, effort, moved);
  run.seconds = processor_seconds() - start;
  return run;
}

inline constexpr Family plain{
    verner_run, extrapolation_run, "Verner's pair 9(8) and Gragg's extrapolation", verner_run, 0,
    {9, 13}};
/// The weights of extrapolation amplify rounding: where there is a series, it is not needed.
inline constexpr Family by_series{taylor_run, verner_run, "Taylor's series and Verner's pair 9(8)",
                                  verner_run, 0,          {28, 9}};
/// Its first method estimates an error of four orders less.
inline constexpr Family implicit_family{
    radau_run,
    implicit_extrapolation_run,
    "Radau IIA of order 13 and the extrapolated implicit Euler method",
    radau_run,
    finest_implicit_extrapolation,
    {12, 8}};

}  // namespace odeum::truth
