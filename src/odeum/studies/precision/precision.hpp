// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/measure/run_record.hpp"
#include "odeum/studies/stopwatch.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// One solver at one setting: a line of precision.csv. The error is the largest of a measured
/// component at the stops, absolute, from a run under the guard, which also counts; the times are
/// of runs with the bare right-hand side, set-up included; of what cannot be the fastest, and whose
/// guard costs next to nothing, the guarded run's processor time (timing.hpp). Conditions are those
/// of the case's timed runs.
struct PrecisionRow : measure::RunRecord, WallTimes, Conditions {
  std::string absolute;  ///< absolute tolerance, or those of all components; of a tolerance run
  std::string options;   ///< values given to the solver's own options: name=value, by spaces
  std::string jacobian;  ///< what the case offers to solvers that use df/dy, see jacobian_of
  /// The largest error at the neighbouring settings: steps 2 % and 5 % more and, where the grid
  /// allows it, fewer; tolerances 1.1 and 1.25 times as large and as small. NaN where these were
  /// not run.
  double near_error = nan;
  /// How the timed runs call it: `function pointer`, `inlined` (compiled into the solver), or
  /// `guarded`: the time is that of the run that gave the error.
  std::string right_hand_side = "function pointer";
  /// `with optimisation` or `without optimisation`; empty for what is compiled with the program.
  std::string library_compiled;
  bool pareto = false;    ///< no other row is both faster and more accurate
  std::string processor;  ///< its model; that of all rows of a case

  bool timed() const { return repetitions > 0 && !std::isnan(error); }

  static constexpr const char* file = "precision.csv";
  /// 2: the answer; 3: absolute tolerance, options, Jacobian; 4: guarded times; 5: near_error;
  /// 6: library_compiled; 7: processor
  static constexpr int schema = 7;
  static constexpr bool compared_within_case = true;
  ODEUM_COLUMNS(case_id, library, solver, status, detail,
                column("setting_kind", PhraseColumn{mode, "step", "tol"}), setting,
                column("absolute_tolerance", absolute), options, jacobian, error, near_error,
                wall_ns_min, wall_ns_median, repetitions, counters.rhs_evaluations,
                counters.jacobian_evaluations, counters.steps, counters.rejected_steps,
                right_hand_side, library_compiled, pareto, drift, processor_share, measured, judged,
                processor)
};

/// The error reached at a tolerance: a line of tolerances.csv.
struct ToleranceRow {
  std::string case_id, library, solver;
  double requested = 0, achieved = 0;
  judge::Answer answer = judge::Answer::not_applicable;

  static constexpr const char* file = "tolerances.csv";
  static constexpr int schema = 2;  ///< 2: the answer
  static constexpr bool compared_within_case = true;
  ODEUM_COLUMNS(case_id, library, solver, requested, achieved,
                column("achieved_over_requested", ComputedColumn{achieved / requested}), answer)
};

/// The fastest own solver and the fastest peer at an error on a case: a line of
/// precision_summary.csv. Empty and NaN where none reaches the error.
struct PrecisionSummary {
  std::string case_id;
  double error = 0;
  std::string own, peer;
  double own_ns = 0, peer_ns = 0;
  /// peer_ns / own_ns: above one, Odeum is faster; from the minimal times; its interval compares
  /// the minimum of one with the median of the other.
  double ratio = 0, ratio_low = 0, ratio_high = 0;
  std::string reason;  ///< why there is no ratio

  static constexpr const char* file = "precision_summary.csv";
  static constexpr bool compared_within_case = true;
  ODEUM_COLUMNS(case_id, error, own, own_ns, peer, peer_ns, ratio, ratio_low, ratio_high, reason)
};

/// The fastest solver of one library at an error on a case, a run that was made and timed: a line
/// of fastest.csv. Libraries that do not reach the error have none.
struct FastestRow : measure::RunRecord, WallTimes {
  double compared = nan;  ///< the error that it reaches
  std::string options;    ///< this and the next as in PrecisionRow
  double near_error = nan;

  static constexpr const char* file = "fastest.csv";
  static constexpr int schema = 3;  ///< 2: options; 3: only runs that were made, their errors
  static constexpr bool compared_within_case = true;
  ODEUM_COLUMNS(case_id, column("error", compared), library, solver,
                column("setting_kind", PhraseColumn{mode, "step", "tol"}), setting, options,
                wall_ns_min, wall_ns_median, column("achieved", error), near_error,
                counters.rhs_evaluations, counters.steps)
};

/// A run to a tolerance with many outputs, made in two ways: with steps that end on each, and with
/// states between the steps by the solver's own interpolant, where its library has one
/// (Request::over_stops). A line of precision_outputs.csv. `work` is in evaluations and products;
/// errors are the largest at the outputs at which the truth is known.
struct OutputRow {
  std::string case_id, library, solver;
  std::string status, detail;
  double tolerance = 0;
  std::uint64_t outputs = 0;
  std::uint64_t steps_ends = 0, steps_between = 0, work_ends = 0, work_between = 0;
  double error_ends = nan, error_between = nan;

  static constexpr const char* file = "precision_outputs.csv";
  ODEUM_COLUMNS(case_id, library, solver, status, detail, tolerance, outputs, steps_ends,
                steps_between, work_ends, work_between, error_ends, error_between)
};

struct PrecisionResult {
  std::vector<PrecisionRow> rows;
  std::vector<ToleranceRow> tolerances;
  std::vector<PrecisionSummary> summary;
  std::vector<FastestRow> fastest = {};
  std::vector<OutputRow> outputs = {};
  static auto lists(auto& result) {
    return std::tie(result.rows, result.tolerances, result.summary, result.fastest, result.outputs);
  }
};

inline const Option timed_seconds{.name = "seconds",
                                  .help = "what the timed runs of a case may take, roughly",
                                  .least = 1e-3,
                                  .otherwise = 4};
inline const Option solve_seconds{.name = "solve-seconds",
                                  .help = "a solve that takes longer is over budget",
                                  .least = 1e-3,
                                  .otherwise = 2};
inline const Option most_attempts =
    whole_number("attempts", 1, 100, "how often a case that other programs disturbed is timed", 2);

/// Speed against error for every fitting pair. Timed runs go round robin over the solvers within a
/// setting, on one pinned processor; a case during which the machine's own speed drifted by more
/// than 5 %, or other programs had the processor for more than that, is timed once more, and marked
/// where it is disturbed again. Throws Interrupted.
PrecisionResult measure_precision(const Options& options, const Runner& runner = Runner());

/// What a case offers to solvers that use df/dy: `exact`, `products` (with a vector, exact), or
/// `differenced`: nothing, so that they difference the right-hand side, own ones and peers alike.
std::string jacobian_of(const Case& c);

/// Marks the Pareto-optimal rows of one case in time and error.
void mark_pareto(std::vector<PrecisionRow>& rows);

/// The compared errors: 1e-2 ... 1e-12.
std::vector<double> compared_errors();

/// Whether a run reaches an error, and not by luck: the neighbouring settings keep it, or miss it
/// by less than twice and are not several times as far off as the run itself. `own`, `near`: its
/// error and the largest of the neighbours, NaN where these were not run.
bool keeps_error(double own, double near, double error);
/// The same for a row, which has to be timed.
bool reaches(const PrecisionRow& row, double error);

/// The fastest of each library at each compared error over the rows of one case: always a row that
/// reaches it. Errors at or below the truth's floor are not compared.
std::vector<FastestRow> fastest(const std::vector<PrecisionRow>& rows, double floor);

/// The fastest own solver and the fastest peer at each of these errors.
std::vector<PrecisionSummary> summarise(const std::vector<PrecisionRow>& rows, double floor);

}  // namespace odeum::study
