// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "odeum/brought/likeness.hpp"
#include "odeum/brought/trajectory.hpp"
#include "odeum/core/numbers.hpp"
#include "odeum/judge/order_fit.hpp"
#include "odeum/record/row.hpp"

namespace odeum::brought {

/// What is claimed of the files.
struct Claim {
  std::string method;  ///< an own method's id; empty: none
  double order = nan;  ///< NaN: none is claimed
  /// The half width of a tube around the truth, in the units of errors and of time; 0: none.
  double tube = 0, tube_time = 0;
};

/// A run that was brought, against the truth.
struct FileRow {
  std::string series, path;
  std::string status;         ///< ok; diverged: a number is not finite; unknown: no truth
  double step = nan;          ///< mean of the time between rows where steps are not known
  double rows = 0;            ///< that were compared
  double end = nan;           ///< the last time that was compared
  double error = nan;         ///< the largest of them, see judge::error_of
  double error_time = nan;    ///< when that is
  std::string component;      ///< and of which component
  double written = nan;       ///< the error that half a unit of the last written place comes to
  double leaves_at = nan;     ///< when the error first exceeds a hundredth of the solution's size
  double lag = nan;           ///< at the end, how far behind the truth along its path, in time
  double aside = nan;         ///< the error there that such a shift in time leaves
  double energy_error = nan;  ///< the largest, over the largest energy of the truth
  double outside = nan;       ///< the share of the times outside of the tube
  /// Where no truth is known, see RowToRow: the error that a row gains, by the unit of time, and by
  /// how much an invariant changes.
  double gain = nan, change = nan;
  std::string remarks;  ///< sentences on how the file was read

  static constexpr const char* file = "files.csv";
  static constexpr const char* shown =
      "path step:.4g status error:.2e error_time:.4g component leaves_at:.4g energy_error:.1e";
  /// Where no truth is known.
  static constexpr const char* shown_alone = "path step:.4g status gain:.2e change:.1e";
  ODEUM_COLUMNS(series, path, status, step, rows, end, error, error_time, component, written,
                leaves_at, lag, aside, energy_error, outside, gain, change, remarks)
};

/// What became of a claim.
enum class Claimed { not_applicable, held, denied, open };
const char* to_string(Claimed claimed);

/// The runs of one program at several steps.
struct SeriesRow {
  std::string series;
  std::string method;  ///< that is claimed
  double claimed_order = nan;
  Claimed claim = Claimed::not_applicable;
  judge::Verdict verdict = judge::Verdict::not_applicable;
  double measured_order = nan, order_low = nan, order_high = nan;
  double own_order = nan;  ///< with which the differences of the files fall, whatever the truth
  std::string likeliest;   ///< the method whose steps the rows are
  std::string mistake;     ///< what it does otherwise
  std::string reason;      ///< sentences

  static constexpr const char* file = "judged.csv";
  ODEUM_COLUMNS(series, method, claimed_order, claim, verdict, measured_order, order_low,
                order_high, own_order, likeliest, mistake, reason)
};

struct Judgement {
  std::vector<SeriesRow> series = {};
  std::vector<FileRow> files = {};
  static auto lists(auto& result) { return std::tie(result.series, result.files); }
  /// Whether no claim is denied and no time lies outside of a tube.
  bool passes() const;
};

/// The times at which the truth has to be known, ascending: for each series those that its files
/// have in common, at most 200 a file.
std::vector<double> times_of(const Case& c, const std::vector<Trajectory>& runs,
                             const Claim& claim);

/// Judges runs of a case whose truth is known as far as it can be at times_of(). Throws
/// Interrupted.
Judgement judge_runs(const Case& c, const std::vector<Trajectory>& runs, const Claim& claim);

/// For a terminal: a paragraph a series, and the table of files.
std::string text_of(const Judgement& judgement, const Case& c);

}  // namespace odeum::brought
