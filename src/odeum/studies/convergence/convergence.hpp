// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/judge/order_fit.hpp"
#include "odeum/measure/run_record.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// One solve: a line of convergence.csv. Errors are absolute, in the case's units, over all stops
/// and measured components; that of the energy is relative to the largest |energy| of the truth at
/// the stops.
struct ConvergenceRow : measure::RunRecord {
  double step = nan;        ///< of a run to a tolerance the mean one
  std::uint64_t steps = 0;  ///< at a fixed step those asked for

  static constexpr const char* file = "convergence.csv";
  /// 2: the answer of a run to a tolerance; 3: the setting in place of the tolerance
  static constexpr int schema = 3;
  ODEUM_COLUMNS(case_id, library, solver, status, detail, step, steps, column("error_max", error),
                error_rms, energy_error, counters.rhs_evaluations, counters.jacobian_evaluations,
                mode, setting, counters.rejected_steps, judged)
};

/// The error of one solve at one stop: a line of convergence_times.csv.gz.
struct TimeRow {
  std::string case_id, library, solver;
  Mode mode = Mode::fixed;
  double step = 0, time = 0;
  double error_max = 0, error_rms = 0;
  double energy = 0, energy_error = 0;

  static constexpr const char* file = "convergence_times.csv.gz";
  ODEUM_COLUMNS(case_id, library, solver, mode, step, time, error_max, error_rms, energy,
                energy_error)
};

/// The row of a stop of a run with errors. Errors have six digits and energies nine: all of the
/// rest is noise of the measurement, and half of the file.
TimeRow time_row(const ConvergenceRow& run, const judge::StopError& stop);

/// The order of one solver on one case: a line of orders.csv.
struct OrderRow {
  std::string case_id, library, solver;
  Mode mode = Mode::fixed;
  double claimed_order = 0;
  judge::OrderFit fit;

  static constexpr const char* file = "orders.csv";
  static constexpr const char* shown =
      "case solver mode claimed_order:.3g measured_order:.3f verdict";
  static constexpr int schema = 2;  ///< 2: why there is no order
  ODEUM_COLUMNS(case_id, library, solver, claimed_order, column("measured_order", fit.order),
                column("order_low", fit.low), column("order_high", fit.high), fit.points,
                fit.step_coarsest, fit.step_finest, fit.floor, fit.verdict, fit.reason, mode,
                fit.floor_step, fit.floor_scale, column("no_order", fit.why))
};

struct ConvergenceResult {
  std::vector<ConvergenceRow> rows = {};
  std::vector<TimeRow> times = {};
  std::vector<OrderRow> orders = {};
  static auto lists(auto& result) { return std::tie(result.rows, result.times, result.orders); }
};

/// Error against step for every fitting pair in both modes; `quick`: at fewer step sizes. Throws
/// Interrupted.
ConvergenceResult converge(const Options& options, const Runner& runner = Runner());

/// How the solvers of one library did. A pair is a solver on a case in a mode.
struct LibrarySummary {
  std::string library;
  std::size_t solvers = 0, pairs = 0;
  std::array<std::size_t, static_cast<std::size_t>(judge::Verdict::not_applicable) + 1>
      verdicts{};  ///< counts by Verdict
};
/// One entry a library, then one for all of them, with the name "all".
std::vector<LibrarySummary> summarise(const report::Facts& facts,
                                      const std::vector<OrderRow>& orders);
/// The same for a terminal.
std::string summary_text(const report::Facts& facts, const std::vector<OrderRow>& orders);

}  // namespace odeum::study
