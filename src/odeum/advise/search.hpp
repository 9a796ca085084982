// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>

#include "odeum/advise/race.hpp"
#include "odeum/core/clocks.hpp"

/// The setting of each candidate for the error asked.
namespace odeum::advise {

/// The stops of a run: all of them, on which steps end or inside of steps, or one of them.
enum class To { all, inside, first, end };

/// Finds settings by runs under the guard. Not thread-safe: runs are timed.
class Search {
 public:
  /// `frames`: fixed steps are a multiple of them; 0: of the case's own.
  Search(const std::vector<const Case*>& cases, const Wishes& wishes, std::uint64_t frames = 0);

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
  Trial run(const Candidate& candidate, double fineness, To to = To::all) const;
  /// The run of the setting found as its command makes it, with no stop but the end; its errors are
  /// those at all stops, inside of its steps. Where it misses the error, a finer setting that keeps
  /// it at less than twice the work.
  Trial as_command(const Candidate& candidate) const;
  /// The same at a setting.
  Trial command_run(const Candidate& candidate, double fineness) const;
  /// A tenth of the tolerance's fineness, or half as many steps, where those end on the stops.
  double coarser_than(const Candidate& candidate, double fineness) const;
  bool late(double share) const;
  /// Seconds for the race: what the truth has left of those asked for, half of them at least.
  double left() const;
  /// Wall time of the trial's runs with the bare right-hand side, mean of the cases; infinite where
  /// one fails.
  double bare_ns(const Candidate& candidate, const Trial& trial) const;
  double seconds() const { return seconds_; }
  /// Whether a run takes so long that not every candidate has its turn.
  bool dear() const { return dear_; }

 private:
  static void order_by_rank(std::vector<Candidate>& candidates);
  /// Runs to the first stop of one candidate of each kind, which foresee what the others cost;
  /// whether a run is dear.
  bool heats(std::vector<Candidate>& candidates);
  Trial heat(Candidate& candidate);
  void foresee(Candidate& candidate, const Trial& trial) const;
  /// Visits the candidates of dear runs in the order foreseen; of each library the best one at
  /// least.
  void each_worth(std::vector<Candidate>& candidates, const std::function<void(Candidate&)>& visit);
  void search_cheap(std::vector<Candidate>& candidates);
  void try_longer(std::vector<Candidate>& candidates);
  void search_within(Candidate& candidate);
  void settle_within(Candidate& candidate) const;
  /// A run with the time that it takes without the guard.
  void take_within(Candidate& candidate, double fineness);
  /// The error at the time, by its last run and its order; NaN where that failed.
  double foreseen_error(const Candidate& candidate) const;
  /// A run, after which one that is too slow is dropped.
  void take(Candidate& candidate, double fineness);
  void search(Candidate& candidate, std::size_t most, double decades);
  measure::SettingGrid grid_of(const Candidate& candidate) const;
  /// Ends where the error is known to so many decades.
  measure::SettingSearch settings_of(const Candidate& candidate, double decades = 0) const;
  /// The coarsest of its trials that reaches the error; null: none.
  const Trial* coarsest_of(const Candidate& candidate) const;
  double first(const Candidate& candidate) const;
  double part_of(To to) const;
  double whole_ns(const Candidate& candidate, const Trial& to_first) const;
  /// The time, or the least error within the time, of the best run; infinite without one.
  double best_cost() const { return wishes_.time_ns > 0 ? least_error_ : best_ns_; }
  double in_range(const Candidate& candidate, double fineness) const;
  void settle(Candidate& candidate) const;

  /// A case with its judges, by the stops of a run.
  struct Stage {
    const Case* c = nullptr;
    judge::Judge all, first, end;
    double first_energy = nan;
    const judge::Judge& judge(To to) const {
      return to == To::first ? first : to == To::end ? end : all;
    }
  };
  Request request_for(const Stage& stage, const Candidate& candidate, double fineness, To to) const;
  Status run_on(const Stage& stage, const Entrant& entrant, Part& part, To to) const;
  void take_errors(Trial& trial) const;
  double drift_to_horizon(const Stage& stage, const Entrant& entrant, const Part& part) const;

  const Case& c_;  ///< the first
  Wishes wishes_;
  double first_;  ///< the stop of runs that foresee others
  std::vector<Stage> stages_;
  std::uint64_t multiple_;  ///< of numbers of fixed steps
  double seconds_;
  bool dear_ = false;     ///< runs are
  double patience_ = 10;  ///< a run is stopped after so many times the best run's time
  double best_ns_ = infinity, cap_seconds_ = 0, least_error_ = infinity;
  double before_;  ///< seconds that the truth took
  Clock clock_;
};

}  // namespace odeum::advise
