// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/core/request.hpp"
#include "odeum/core/status.hpp"

/// At which setting a solver has an error, or takes a time. Settings are counted by their fineness:
/// the number of steps, or the inverse of the relative tolerance.
namespace odeum::measure {

/// The settings that there are.
struct SettingGrid {
  Mode mode = Mode::adaptive;
  std::uint64_t multiple = 1;  ///< of numbers of steps
  bool two_digits = false;     ///< tolerances are those of of_two_digits

  /// The nearest setting that is not coarser, but for rounding: from one multiple of steps to 1e8,
  /// or of tolerances from 1e-1 to 1e-14.
  double on_grid(double fineness) const;
};

/// A run that was tried.
struct Tried {
  double fineness = 0;
  Status status = Status::ok;
  double error = nan;  ///< NaN where it failed
  double ns = 0;

  bool reaches(double asked) const { return status == Status::ok && error <= asked; }
};

/// The next setting to try, by those tried:
///
///   SettingSearch search{.grid = grid, .slope = order};
///   while (const double fineness = search.next(1e-6)) search.tried.push_back(run(fineness));
///
/// For one thread at a time.
struct SettingSearch {
  SettingGrid grid;
  std::vector<Tried> tried = {};
  double slope = 1;  ///< the error falls as the fineness to this power
  /// The search for an error ends at a run that reaches it with so much of it, or that is so many
  /// times as fine as one that misses it.
  double close = infinity, narrow = 1;
  /// A setting coarser than all that were tried is between these times as fine.
  double coarser_least = 1e-3, coarser_most = 1 / 1.3;
  /// The size of the solution: an error as large tells that a run is unstable, and nothing else.
  double size = infinity;

  /// Positions in `tried`; -1: there is none. The coarsest that reaches the error, and the finest
  /// of those coarser that miss it; a run that was stopped says neither.
  struct Bracket {
    std::ptrdiff_t misses = -1, reaches = -1;
  };
  Bracket bracket(double error) const;
  /// The run at this setting, but for rounding; null: none.
  const Tried* at(double fineness) const;

  /// The fineness of the next run for an error; 0: the search has ended. Needs one that was tried.
  double next(double error) const;
  /// The same for the finest setting that keeps to a time; it aims at a share of that. The time of
  /// a run grows as the fineness to 1 / power.
  double next_within(double ns, double share, double power) const;

 private:
  double between(const Tried& misses, const Tried& reaches, double error) const;
  double finer_than(const Tried& misses, double expected) const;
  double new_one(double fineness) const;
};

}  // namespace odeum::measure
