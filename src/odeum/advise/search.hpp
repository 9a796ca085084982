// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/advise/race.hpp"

/// The setting of each candidate for the error asked.
namespace odeum::advise {

/// Finds settings by runs under the guard. Not thread-safe: runs are timed.
class Search {
 public:
  /// `frames`: fixed steps are a multiple of them; 0: of the case's own.
  Search(const Case& c, const Wishes& wishes, std::uint64_t frames = 0);

  /// Every candidate, those first that seem cheapest by their first run.
  void all(std::vector<Candidate>& candidates);
  /// Until the coarsest setting that reaches the error is known to an eighth of a decade of error,
  /// and the settings beside it keep to twice the error.
  void refine(Candidate& candidate);
  /// Every candidate, at the setting of least error that keeps to the time.
  void all_within(std::vector<Candidate>& candidates);
  /// Another setting for one that takes `ns`, more than the time, or far less; false: there is
  /// none that is better.
  bool adjust_within(Candidate& candidate, double ns);
  /// A run that is only looked at.
  Trial run(const Candidate& candidate, double fineness, bool only_end = false) const;
  bool late(double share) const;

 private:
  static void order_by_rank(std::vector<Candidate>& candidates);
  void search_within(Candidate& candidate);
  /// A run with the time that it takes without the guard.
  void take_within(Candidate& candidate, double fineness);
  /// At the time, by its last run and its order; NaN where that failed.
  double foreseen_error(const Candidate& candidate) const;
  double next_within(const Candidate& candidate, double share) const;
  void take(Candidate& candidate, double fineness);
  void search(Candidate& candidate, std::size_t most, double decades);
  double next(const Candidate& candidate, double decades) const;
  double first(const Candidate& candidate) const;
  double in_range(const Candidate& candidate, double fineness) const;
  void drop_if_slow(Candidate& candidate) const;
  void settle(Candidate& candidate) const;

  const Case& c_;
  Wishes wishes_;
  judge::Judge judge_, end_judge_;
  std::uint64_t multiple_;  ///< of numbers of fixed steps
  double best_ns_ = infinity, cap_seconds_ = 0, least_error_ = infinity;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace odeum::advise
