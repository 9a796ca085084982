// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include "odeum/cases/conditions.hpp"
#include "odeum/measure/local.hpp"
#include "odeum/why/kink.hpp"

/// States between those that are known of a run, and where conditions of the equations change on
/// the way.
namespace odeum::why {

/// The way of a run: cubics of Hermite between its states. The case and the run outlive it.
class Path {
 public:
  Path(const Case& c, const std::vector<Moment>& moments);
  double start() const { return moments_.front().t; }
  double end() const { return moments_.back().t; }
  std::vector<double> state(double t) const;
  /// The right-hand side there.
  std::vector<double> slope(double t) const;

 private:
  const Case& c_;
  const std::vector<Moment>& moments_;
  std::vector<std::vector<double>> slopes_;  ///< at the moments
};

/// A condition that changes: just before and just after, as near as doubles of t allow.
struct Change {
  std::size_t condition = 0;
  double before = 0, after = 0;
};
/// The changes between the times given, which ascend, in the order of time: each condition has at
/// most one between two of them.
std::vector<Change> changes_along(const Path& path, const cases::Conditions& conditions,
                                  const std::vector<double>& times);

/// Times at which conditions are looked at: the states, some between two of them, and even ones.
std::vector<double> times_along(const Path& path, const std::vector<Moment>& moments);

/// Whether both sides of a condition lead to the states at which it changes, of which (t, y) is
/// nearly one: the solution stays there.
bool holds_the_solution(const Case& c, const cases::Conditions& conditions, double t,
                        const std::vector<double>& y, std::size_t condition,
                        const std::vector<double>& sizes);

/// The kinks and jumps where conditions of the equations change along states, which end `wide`
/// after the last with `ahead`; one at which the solution stays is the last.
struct Changed {
  std::vector<Kink> kinks;
  bool stays = false;
  double until = 0;  ///< up to when it stays there
};
Changed kinks_of_conditions(const Case& c, const cases::Conditions& conditions,
                            std::vector<Moment> moments, double wide, bool ahead,
                            const std::vector<double>& sizes);

/// The state a time `by` later, along the slope.
Moment ahead_of(const Case& c, const Moment& from, double by);

}  // namespace odeum::why
