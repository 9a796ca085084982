// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <set>
#include <vector>

#include "odeum/judge/amplification.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/measure/setting_search.hpp"
#include "odeum/solvers/variants.hpp"
#include "odeum/studies/precision/precision.hpp"
#include "odeum/studies/stopwatch.hpp"

/// The runs of the solvers of one case: guarded ones, which count evaluations and measure errors,
/// and then timed ones.
namespace odeum::study {

/// A setting of a solver: its row, and the data for a timed run.
struct TimedRun {
  PrecisionRow row;
  Request request;
  Status status = Status::ok;  ///< of the guarded run
  std::vector<double> states;
  double guarded_ns = 0;           ///< processor time of the guarded run
  bool cannot_be_fastest = false;  ///< see mark_slow_solvers
  bool failed = false;             ///< in a timed run: it has no time
  bool done = false;               ///< timed by an earlier call of time_all
  Times times;

  bool ok() const { return row.ok(); }
  /// What the guard takes of the guarded run: 4 ns an evaluation.
  double guard_ns() const { return 4.0 * static_cast<double>(row.counters.rhs_evaluations); }
  /// Whether the guarded run is long enough for one measurement.
  bool measurable() const { return guarded_ns > 2e5; }
  /// Whether the guard takes at most a twentieth of it as well.
  bool lightly_guarded() const { return measurable() && 20 * guard_ns() <= guarded_ns; }
  /// Whether its time is that of the guarded run.
  bool guarded() const { return row.right_hand_side == "guarded"; }
};

/// A solver on a case in one mode, with its settings from coarse to fine.
struct TimedSolver {
  const Entrant* entrant;
  Mode mode;
  const Entrant* inlined;  ///< the same for timed runs; null where there is none
  Variant options = {};
  std::vector<TimedRun> trials = {};
  std::set<double> searched = {};  ///< the errors whose settings were searched, see settle_errors
};

struct TimedCase {
  const Case& c;
  std::vector<double> stops;
  double floor;
  judge::Judge judge;
  judge::Amplification amplification;

  explicit TimedCase(const Case& each)
      : c(each),
        stops(each.timed_stops()),
        floor(each.timed_floor()),
        judge(each, stops),
        amplification(judge::measure_amplification(each, stops)) {}

  /// The ratio of the horizon to that of other studies.
  double stretch() const { return std::max(1.0, (stops.back() - c.t0) / (c.stops.back() - c.t0)); }
};

/// One guarded run, which counts evaluations and measures the error.
TimedRun run_guarded(const TimedCase& stage, const Entrant& entrant, const Request& request);

/// Runs a solver at the settings of its mode, from coarse to fine, each for `seconds` at most, as
/// far as the budget goes.
void run_guarded(const TimedCase& stage, TimedSolver& solver, double seconds);

/// The solvers of a case that choose their steps, each with a hundred outputs and more.
std::vector<OutputRow> measure_outputs(const TimedCase& stage, const Options& options,
                                       unsigned jobs);

/// A library none of whose solvers solves a case within the budget may have one that does beyond:
/// its solvers that ended over budget run once more, to the loosest tolerance, with thirty times
/// the evaluations that the case allows.
void run_beyond_budget(const TimedCase& stage, std::vector<TimedSolver>& solvers,
                       const Runner& runner, double seconds);

/// Interleaved repetitions: round after round over all solvers at a setting, for about `seconds` in
/// all. What cannot be the fastest of its library at its error is run once before, `jobs` at a
/// time, or not again where the guarded run tells its time (lightly_guarded). Runs that an earlier
/// call has timed keep their times. Throws Interrupted.
void time_all(const TimedCase& stage, std::vector<TimedSolver>& solvers, double seconds,
              unsigned jobs = 1);

/// Searches the setting at which a solver just reaches an error, for the solvers of each library
/// that promise the least times, by their timed runs, and for which no known run shows that they
/// cannot be the fastest. What is found is a run that keeps the error within twice at the
/// neighbouring settings too (PrecisionRow::near_error), and joins the trials, not timed yet.
/// Returns whether it ran anything: after the next time_all others may promise more.
bool settle_errors(const TimedCase& stage, std::vector<TimedSolver>& solvers, unsigned jobs);

/// Runs the neighbouring settings of timed runs that are faster than what is known to reach an
/// error, so that the fastest of a library is the fastest of its runs that reach it not by luck.
void check_fastest(const TimedCase& stage, std::vector<TimedSolver>& solvers, unsigned jobs);

}  // namespace odeum::study
