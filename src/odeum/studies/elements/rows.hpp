// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <tuple>
#include <vector>

#include "odeum/judge/order_fit.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::study {

/// One problem solved by linear triangles on one mesh.
struct ElementsRow {
  std::string problem, rule;  ///< rule: of the quadrature of the load
  std::string status, detail;
  std::size_t divisions = 0;  ///< of a unit length of the region
  std::size_t triangles = 0, unknowns = 0;
  double h = nan;                            ///< longest edge
  double l2 = nan, h1 = nan, maximum = nan;  ///< errors
  double centre = nan;                       ///< |error| in the middle of the region, where known
  std::size_t iterations = 0;  ///< of conjugate gradients with a V-cycle, residual 1e-11

  static constexpr const char* file = "elements.csv";
  ODEUM_COLUMNS(problem, rule, status, detail, divisions, triangles, unknowns, h,
                column("error_l2", l2), column("error_h1", h1), column("error_max", maximum),
                column("error_centre", centre), iterations)
};

/// The order in h of one error of one problem.
struct ElementsOrderRow {
  std::string problem, rule, norm;  ///< norm: l2, h1, max, max_by_log, centre
  double claimed_order = nan;
  judge::OrderFit fit;
  double finest = nan;  ///< the error on the finest mesh
  std::string theory;   ///< why this order is expected, or why none is kept

  static constexpr const char* file = "elements_orders.csv";
  static constexpr const char* shown =
      "problem rule norm claimed_order:.2f measured_order:.2f error_finest:.2e verdict theory";
  ODEUM_COLUMNS(problem, rule, norm, claimed_order, column("measured_order", fit.order),
                column("order_low", fit.low), column("order_high", fit.high), fit.points,
                column("h_coarsest", fit.step_coarsest), column("h_finest", fit.step_finest),
                fit.floor, column("error_finest", finest), fit.verdict, fit.reason, theory)
};

/// One triangle of a coarse mesh with the solution at its nodes, for a picture.
struct ElementsFieldRow {
  std::string problem;
  std::size_t divisions = 0;
  double x[3] = {}, y[3] = {};      ///< of the nodes, counterclockwise
  double u[3] = {}, error[3] = {};  ///< the solution there, and what it has too much

  static constexpr const char* file = "elements_fields.csv";
  ODEUM_COLUMNS(problem, divisions, column("x1", x[0]), column("y1", y[0]), column("x2", x[1]),
                column("y2", y[1]), column("x3", x[2]), column("y3", y[2]), column("u1", u[0]),
                column("u2", u[1]), column("u3", u[2]), column("error1", error[0]),
                column("error2", error[1]), column("error3", error[2]))
};

/// One linear solver on the system of one mesh, right-hand side of a random solution, until the
/// energy norm of the error is 1e-8 of what it was.
struct ElementsSolverRow {
  std::string problem, solver;  ///< solver: library/method
  std::string status, detail;
  std::size_t divisions = 0, unknowns = 0;
  std::size_t iterations = 0;
  /// Highest over lowest eigenvalue of M^-1 A; NaN where the library does not tell.
  double condition = nan;
  double spectral_radius = nan;   ///< of I - M^-1 A, for iterations that repeat it
  double rate = nan;              ///< of the error per iteration, over the second half of them
  double bound = nan;             ///< the textbook bound of that rate in the energy norm
  double iterations_bound = nan;  ///< iterations that the bound allows
  double residual = nan;          ///< |b - A x| / |b| in the end

  static constexpr const char* file = "elements_solvers.csv";
  static constexpr const char* shown =
      "problem divisions solver iterations iterations_bound:.0f condition spectral_radius:.4f "
      "rate:.4f rate_bound:.4f status";
  ODEUM_COLUMNS(problem, solver, status, detail, divisions, unknowns, iterations, condition,
                spectral_radius, rate, column("rate_bound", bound), iterations_bound, residual)
};

/// A solver that stops at one residual: what is left of the error, and what the mesh leaves anyway.
struct ElementsStoppingRow {
  std::string problem, solver;
  std::size_t divisions = 0, unknowns = 0;
  double tolerance = nan;  ///< of |b - A x| / |b|
  std::size_t iterations = 0;
  double algebraic = nan;       ///< error of the solver in the energy norm
  double discretisation = nan;  ///< error of the mesh in it: of the exact discrete solution
  double total = nan;           ///< error of what the solver gave, measured

  static constexpr const char* file = "elements_stopping.csv";
  static constexpr const char* shown =
      "solver divisions tolerance:.0e iterations error_algebraic:.2e error_discretisation:.2e "
      "error_total:.2e";
  ODEUM_COLUMNS(problem, solver, divisions, unknowns, tolerance, iterations,
                column("error_algebraic", algebraic),
                column("error_discretisation", discretisation), column("error_total", total))
};

/// The time of one linear solver on the system of the finest mesh, to a residual of 1e-8.
struct ElementsTimeRow {
  std::string problem, solver;
  std::string status, detail;
  std::size_t divisions = 0, unknowns = 0, iterations = 0, repetitions = 0;
  double setup_ns = nan;  ///< factors, coarser matrices; least
  double solve_ns_min = nan, solve_ns_median = nan;
  double residual = nan;

  static constexpr const char* file = "elements_times.csv";
  static constexpr const char* shown =
      "solver unknowns iterations setup_ns_min:.3g solve_ns_min:.3g solve_ns_median:.3g "
      "residual:.1e status";
  ODEUM_COLUMNS(problem, solver, status, detail, divisions, unknowns, iterations, repetitions,
                column("setup_ns_min", setup_ns), solve_ns_min, solve_ns_median, residual)
};

struct ElementsResult {
  std::vector<ElementsRow> meshes = {};
  std::vector<ElementsOrderRow> orders = {};
  std::vector<ElementsFieldRow> fields = {};
  std::vector<ElementsSolverRow> solvers = {};
  std::vector<ElementsStoppingRow> stopping = {};
  std::vector<ElementsTimeRow> times = {};
  static auto lists(auto& result) {
    return std::tie(result.meshes, result.orders, result.fields, result.solvers, result.stopping,
                    result.times);
  }
};

/// Errors and orders of the model problems (globs on their ids; empty: all) at up to `most`
/// divisions. Throws Interrupted.
ElementsResult measure_orders(std::size_t most, const Runner& runner,
                              const std::vector<std::string>& cases = {});
/// Iterations of every solver at up to `most` divisions, but no more than 64, against the textbook
/// bound, and what stopping earlier costs. Throws Interrupted.
ElementsResult measure_solvers(std::size_t most, const Runner& runner);
/// Times on the finest mesh, one after the other.
std::vector<ElementsTimeRow> time_solvers(std::size_t most);

inline const Option elements_divisions =
    whole_number("most", 16, 1024,
                 "divisions of a unit length in the finest mesh, of which the largest power of two "
                 "is taken",
                 128);

/// Own options: `problems`, globs on the ids of model problems separated by spaces, whose orders
/// alone are measured, and elements_divisions. Throws Interrupted.
ElementsResult measure_elements(const Options& options, const Runner& runner = Runner());

}  // namespace odeum::study
