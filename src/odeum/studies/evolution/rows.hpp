// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "odeum/judge/order_fit.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// A run of the heat or the wave equation on one mesh: linear elements on right triangles of the
/// unit square, lumped mass, u = 0 on the boundary. Errors at the end, in the L2 norm of the
/// vertex rule, against the size of the solution.
struct EvolutionRow {
  std::string problem, solver;  ///< heat or wave; library/method
  std::string status, detail;
  std::size_t divisions = 0, unknowns = 0;  ///< divisions of the edge
  std::size_t steps = 0;
  double dt = nan;
  double error = nan;        ///< against the solution of the equation
  double error_space = nan;  ///< of the exact solution of the system of elements against it
  double error_time = nan;   ///< of the run against the exact solution of the system
  double work = nan;  ///< multiplications of products, factorisations and solutions with factors

  static constexpr const char* file = "evolution.csv";
  static void each(auto& row, auto&& visit) {
    visit("problem", row.problem), visit("solver", row.solver), visit("status", row.status);
    visit("detail", row.detail), visit("divisions", row.divisions);
    visit("unknowns", row.unknowns), visit("steps", row.steps), visit("dt", row.dt);
    visit("error", row.error), visit("error_space", row.error_space);
    visit("error_time", row.error_time), visit("work", row.work);
  }
};

/// The order of a solver's error in the step on one mesh, or in the mesh size at steps whose own
/// error is small.
struct EvolutionOrderRow {
  std::string problem, solver, direction;  ///< direction: time, space
  double claimed_order = nan;
  judge::OrderFit fit;

  static constexpr const char* file = "evolution_orders.csv";
  static constexpr const char* shown =
      "problem solver direction claimed_order:.0f measured_order:.2f verdict";
  static void each(auto& row, auto&& visit) {
    visit("problem", row.problem), visit("solver", row.solver);
    visit("direction", row.direction), visit("claimed_order", row.claimed_order);
    visit("measured_order", row.fit.order), visit("order_low", row.fit.low);
    visit("order_high", row.fit.high), visit("points", row.fit.points);
    visit("coarsest", row.fit.step_coarsest), visit("finest", row.fit.step_finest);
    visit("verdict", row.fit.verdict), visit("reason", row.fit.reason);
  }
};

/// The pair of mesh and step with the least work of a solver for an error.
struct EvolutionCheapestRow {
  std::string problem, solver, status;  ///< status: ok, not_reached
  double target = nan;
  std::size_t divisions = 0, steps = 0;
  double h = nan;  ///< length of the edges along the axes
  double dt = nan, error = nan, work = nan;

  static constexpr const char* file = "evolution_cheapest.csv";
  static constexpr const char* shown =
      "problem target:.0e solver divisions steps h:.3g dt:.3g error:.1e work:.2g status";
  static void each(auto& row, auto&& visit) {
    visit("problem", row.problem), visit("solver", row.solver), visit("status", row.status);
    visit("target", row.target), visit("divisions", row.divisions), visit("steps", row.steps);
    visit("h", row.h), visit("dt", row.dt), visit("error", row.error), visit("work", row.work);
  }
};

/// What a solver makes of one mode, measured and predicted. Heat: `factor`, what 8 steps leave of
/// the fastest mode of a jump; wave: `speed`, that of a wave against the equation's, from one step.
struct EvolutionModeRow {
  std::string problem, mass, solver, quantity;
  std::size_t waves = 0;  ///< half waves in x and in y; 0: the fastest mode
  double step = nan;      ///< heat: eigenvalue times dt, wave: frequency times dt
  double measured = nan, predicted = nan;

  static constexpr const char* file = "evolution_modes.csv";
  static constexpr const char* shown =
      "problem mass solver quantity waves step:.3g observed predicted";
  static void each(auto& row, auto&& visit) {
    visit("problem", row.problem), visit("mass", row.mass), visit("solver", row.solver);
    visit("quantity", row.quantity), visit("waves", row.waves), visit("step", row.step);
    visit("observed", row.measured), visit("predicted", row.predicted);
  }
};

/// The largest stable step of an explicit solver: 2 over the largest eigenvalue (heat, explicit
/// Euler) or frequency (wave, leapfrog) of the elements, and measured by bisection.
struct EvolutionLimitRow {
  std::string problem, mass, solver;
  double predicted = nan, measured = nan;

  static constexpr const char* file = "evolution_limits.csv";
  static constexpr const char* shown = "problem mass solver predicted:.5g observed:.5g";
  static void each(auto& row, auto&& visit) {
    visit("problem", row.problem), visit("mass", row.mass), visit("solver", row.solver);
    visit("predicted", row.predicted), visit("observed", row.measured);
  }
};

/// Steps after which the fastest mode of a jump is measured, and divisions of the mesh of waves.
inline constexpr std::size_t rough_steps = 8, wave_divisions = 16;

struct EvolutionResult {
  std::vector<EvolutionRow> runs;
  std::vector<EvolutionOrderRow> orders;
  std::vector<EvolutionCheapestRow> cheapest;
  std::vector<EvolutionModeRow> modes;
  std::vector<EvolutionLimitRow> limits;
  static auto lists(auto& result) {
    return std::tie(result.runs, result.orders, result.cheapest, result.modes, result.limits);
  }
};

/// Own option `most`: divisions of the finest mesh, of which the largest power of two is taken;
/// default: 128. Throws Interrupted.
EvolutionResult measure_evolution(const Options& options, const Runner& runner = Runner());
/// Its parts that run on a coarse mesh: what is left of rough data, dispersion, explicit limits.
EvolutionResult measure_modes();

}  // namespace odeum::study
