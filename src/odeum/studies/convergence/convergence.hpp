// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "odeum/judge/answer.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/judge/order_fit.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// One solve: a line of convergence.csv. Errors are absolute, in the case's units, over all stops
/// and measured components; NaN where the solve failed or the case has no energy.
struct ConvergenceRow {
  std::string case_id, library, solver;
  Mode mode = Mode::fixed;
  std::string status;  ///< a Status, or not_applicable
  std::string detail;
  double step = 0;       ///< adaptive: the mean step
  double tolerance = 0;  ///< adaptive; NaN at a fixed step
  std::uint64_t steps = 0;
  double error_max = 0, error_rms = 0;
  double energy_error = 0;  ///< relative to the largest |energy| of the truth at the stops
  Counters counters;
  judge::JudgedAnswer judged;  ///< of a run to a tolerance

  static constexpr const char* file = "convergence.csv";
  static constexpr int schema = 2;  ///< 2: the answer of a run to a tolerance
  static void each(auto& row, auto&& visit) {
    visit("case", row.case_id), visit("library", row.library), visit("solver", row.solver);
    visit("status", row.status), visit("detail", row.detail), visit("step", row.step);
    visit("steps", row.steps), visit("error_max", row.error_max), visit("error_rms", row.error_rms);
    visit("energy_error", row.energy_error);
    visit("rhs_evaluations", row.counters.rhs_evaluations);
    visit("jacobian_evaluations", row.counters.jacobian_evaluations), visit("mode", row.mode);
    visit("tolerance", row.tolerance), visit("rejected_steps", row.counters.rejected_steps);
    visit("answer", row.judged.answer), visit("explained_error", row.judged.explained);
    visit("answer_reason", row.judged.reason);
  }
};

/// The error of one solve at one stop: a line of convergence_times.csv.gz.
struct TimeRow {
  std::string case_id, library, solver;
  Mode mode = Mode::fixed;
  double step = 0, time = 0;
  double error_max = 0, error_rms = 0;
  double energy = 0, energy_error = 0;

  static constexpr const char* file = "convergence_times.csv.gz";
  static void each(auto& row, auto&& visit) {
    visit("case", row.case_id), visit("library", row.library), visit("solver", row.solver);
    visit("mode", row.mode), visit("step", row.step), visit("time", row.time);
    visit("error_max", row.error_max), visit("error_rms", row.error_rms);
    visit("energy", row.energy), visit("energy_error", row.energy_error);
  }
};

/// Of a run with errors at its stops. Errors have six digits and energies nine: all of the rest is
/// noise of the measurement, and half of the file.
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
  static void each(auto& row, auto&& visit) {
    visit("case", row.case_id), visit("library", row.library), visit("solver", row.solver);
    visit("claimed_order", row.claimed_order), visit("measured_order", row.fit.order);
    visit("order_low", row.fit.low), visit("order_high", row.fit.high);
    visit("points", row.fit.points), visit("step_coarsest", row.fit.step_coarsest);
    visit("step_finest", row.fit.step_finest), visit("floor", row.fit.floor);
    visit("verdict", row.fit.verdict), visit("reason", row.fit.reason), visit("mode", row.mode);
    visit("floor_step", row.fit.floor_step), visit("floor_scale", row.fit.floor_scale);
    visit("no_order", row.fit.why);
  }
};

/// Why a pair has no order, in words, and what would give it one.
struct OrderClass {
  judge::NoOrder why;
  std::string_view name, settles;
};

/// Those of the verdicts `failed`, `undetermined` and `over_budget`.
std::span<const OrderClass> order_classes();

struct ConvergenceResult {
  std::vector<ConvergenceRow> rows;
  std::vector<TimeRow> times;
  std::vector<OrderRow> orders;
  static auto lists(auto& result) { return std::tie(result.rows, result.times, result.orders); }
};

/// Error against step for every fitting pair in both modes; `quick`: at fewer step sizes. Throws
/// Interrupted.
ConvergenceResult converge(const Options& options, const Runner& runner = Runner());

}  // namespace odeum::study
