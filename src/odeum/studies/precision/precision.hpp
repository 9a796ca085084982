// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"
#include "odeum/record/earlier_csv.hpp"
#include "odeum/record/output_folder.hpp"

namespace odeum::study {

/// One solver at one setting: a line of precision.csv. The error is the largest of a measured
/// component at the stops, absolute, from a run under the guard, which also counts; the times are
/// of runs with the bare right-hand side, set-up included.
struct PrecisionRow {
  std::string case_id, library, solver;
  std::string status;  ///< a Status, or not_applicable
  std::string detail;
  Mode mode = Mode::adaptive;
  double setting = 0;  ///< tolerance, or step
  double error = 0;    ///< NaN where the solve failed
  double wall_ns_min = 0, wall_ns_median = 0;
  std::uint64_t repetitions = 0;
  Counters counters;
  bool inlined = false;  ///< timed with the right-hand side compiled into the solver
  bool pareto = false;   ///< nobody is both faster and more exact
  /// How the machine's own speed changed from before the timed runs of the case to after them, as
  /// a part of it: what another program running does to times. NaN where nothing was timed.
  double drift = std::numeric_limits<double>::quiet_NaN();
  /// The part of the time of the case's timed runs that they had the processor: 1 where no other
  /// program took it. NaN where nothing was timed.
  double processor_share = std::numeric_limits<double>::quiet_NaN();
  std::string measured;  ///< when the case was measured, UTC
};

/// Who is fastest at an error on a case, of Odeum and of all others: a line of
/// precision_summary.csv. Empty and NaN where nobody reaches the error.
struct PrecisionSummary {
  std::string case_id;
  double error = 0;
  std::string own, peer;
  double own_ns = 0, peer_ns = 0;
  /// peer_ns / own_ns: above one, Odeum is faster; from the least times, and its interval from
  /// setting the least time of one against the median of the other.
  double ratio = 0, ratio_low = 0, ratio_high = 0;
  std::string reason;  ///< why there is no ratio
};

struct PrecisionResult {
  std::vector<PrecisionRow> rows;
  std::vector<PrecisionSummary> summary;
};

struct PrecisionOptions {
  std::vector<std::string> cases;    ///< globs on case ids; empty: all
  std::vector<std::string> solvers;  ///< globs on library/method; empty: all
  double seconds_per_case = 4;       ///< what the timed runs of a case may take, roughly
  double seconds_per_solve = 2;      ///< a solve that takes longer ends over budget
  int attempts = 2;                  ///< how often a case is timed at most, while the speed drifts
  unsigned jobs = 1;                 ///< for the runs that are not timed
};

/// Beyond this drift of the machine's speed, or this loss of the processor to others, the times of
/// a case are marked as disturbed.
inline constexpr double most_disturbance = 0.05;
/// False where nothing was timed.
bool disturbed(double drift, double processor_share);

/// Speed against error for every fitting pair. Timed runs go round robin over the solvers within a
/// setting, on one pinned processor; a case during which the machine's own speed drifted by more
/// than 5 %, or other programs had the processor for more than that, is timed once more, and marked
/// where it is disturbed again. Throws Interrupted.
PrecisionResult measure_precision(const PrecisionOptions& options);

/// Marks the rows of one case that nobody beats in both time and error.
void mark_pareto(std::vector<PrecisionRow>& rows);

/// The fastest at each error of 1e-2 ... 1e-12 over the rows of one case; times between two
/// settings of a solver by linear interpolation of log time over log error, never beyond them.
/// Errors at or below the truth's floor are not compared.
std::vector<PrecisionSummary> summarise(const std::vector<PrecisionRow>& rows, double floor);

/// What an earlier run left in a precision.csv.
using EarlierPrecision = record::EarlierRows<PrecisionRow>;
/// No rows and no problem where the file is missing.
EarlierPrecision read_precision_csv(const std::filesystem::path& file);

/// Adds the rows of an earlier run of cases that were not measured now; those of one case compare,
/// as they were measured together. The summary of the added cases is made anew.
void add_earlier(PrecisionResult& result, const std::vector<PrecisionRow>& earlier,
                 const std::vector<Case>& cases);

/// precision.csv, precision_summary.csv and tolerances.csv.
void write_csv(const PrecisionResult& result, const record::OutputFolder& folder);

}  // namespace odeum::study
