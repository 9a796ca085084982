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
  ODEUM_COLUMNS(problem, solver, status, detail, divisions, unknowns, steps, dt, error, error_space,
                error_time, work)
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
  ODEUM_COLUMNS(problem, solver, direction, claimed_order, column("measured_order", fit.order),
                column("order_low", fit.low), column("order_high", fit.high), fit.points,
                column("coarsest", fit.step_coarsest), column("finest", fit.step_finest),
                fit.verdict, fit.reason)
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
  ODEUM_COLUMNS(problem, solver, status, target, divisions, steps, h, dt, error, work)
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
  ODEUM_COLUMNS(problem, mass, solver, quantity, waves, step, column("observed", measured),
                predicted)
};

/// The largest stable step of an explicit solver: 2 over the largest eigenvalue (heat, explicit
/// Euler) or frequency (wave, leapfrog) of the elements, and measured by bisection.
struct EvolutionLimitRow {
  std::string problem, mass, solver;
  double predicted = nan, measured = nan;

  static constexpr const char* file = "evolution_limits.csv";
  static constexpr const char* shown = "problem mass solver predicted:.5g observed:.5g";
  ODEUM_COLUMNS(problem, mass, solver, predicted, column("observed", measured))
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

inline const Option evolution_divisions =
    whole_number("most", 16, 512,
                 "divisions of the finest mesh, of which the largest power of two is taken", 128);

/// Own option: evolution_divisions. Throws Interrupted.
EvolutionResult measure_evolution(const Options& options, const Runner& runner = Runner());
/// Its parts that run on a coarse mesh: what is left of rough data, dispersion, explicit limits.
EvolutionResult measure_modes();

}  // namespace odeum::study
