// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "odeum/compare/folders.hpp"
#include "odeum/compare/result_set.hpp"
#include "odeum/core/numbers.hpp"
#include "odeum/record/row.hpp"

namespace odeum::compare {

/// A solver of newer results among those of older ones, on one case at one error: of each solver
/// the run with the fewest evaluations whose error is at most that.
struct OverlayRow {
  std::string case_id, library, solver;
  double error = nan;        ///< asked for
  double evaluations = nan;  ///< of the right-hand side; NaN: it does not reach that
  std::string best = {};     ///< the older solver with the fewest
  double best_evaluations = nan;
  double ratio = nan;            ///< evaluations over best_evaluations
  double place = nan, of = nan;  ///< among the older solvers that reach it, which are `of`
  /// Its least time over that of the fastest older one, scaled by the runs that both results have;
  /// NaN: there are too few. A hint, since they were not measured in one job.
  double time_hint = nan;

  static constexpr const char* file = "overlay.csv";
  static constexpr const char* shown =
      "case library solver error:.0e evaluations:.0f best best_evaluations:.0f ratio:.3g "
      "place:.0f of:.0f time_hint:.2g";
  ODEUM_COLUMNS(case_id, library, solver, error, evaluations, best, best_evaluations, ratio, place,
                of, time_hint)
};

struct Overlay {
  std::vector<OverlayRow> rows = {};
  std::vector<DifferenceRow> differences = {};  ///< of runs that both have
  std::string speed;                            ///< a sentence: what the hint of speed rests on
  static auto lists(auto& result) { return std::tie(result.rows, result.differences); }
};

/// Lays the solvers of `after` that `before` lacks over the others, by their tables precision.csv;
/// `differences` is left empty.
/// Throws std::invalid_argument where one of them has none, or there is no such solver.
Overlay overlay_of(const ResultSet& before, const ResultSet& after);

}  // namespace odeum::compare
