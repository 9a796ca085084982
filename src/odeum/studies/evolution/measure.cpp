// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "odeum/studies/evolution/field.hpp"
#include "odeum/studies/evolution/rows.hpp"

namespace odeum::study {
namespace {

using std::numbers::pi;

struct Solver {
  const char* id = "";
  double order = 0;
  /// Explicit: the largest stable product of the step with the largest eigenvalue (heat) or
  /// frequency (wave).
  double limit = 0;
};

struct Equation {
  const char* id;
  bool wave;
  double horizon;
  std::span<const Solver> solvers;
};

constexpr Solver of_heat[] = {{"odeum/explicit_euler", 1, 2},
                              {"odeum/rk4", 4, 2.78},
                              {"odeum/implicit_euler", 1},
                              {"odeum/trapezoidal", 2},
                              {"odeum/tr_bdf2", 2}};
constexpr Solver of_wave[] = {{"odeum/velocity_verlet", 2, 2},
                              {"odeum/rk4", 4, 2.82},
                              {"odeum/trapezoidal", 2},
                              {"odeum/tr_bdf2", 2}};
constexpr Equation equations[] = {{"heat", false, 0.05, of_heat}, {"wave", true, 0.5, of_wave}};

/// Two eigenfunctions of the square with different decay and frequency. On this mesh their nodal
/// values are eigenvectors of the elements too: the exact solution of the system is known.
struct SpatialMode {
  int j, k;
  double amplitude;
  double at(fem::Point p) const {
    return amplitude * std::sin(j * pi * p.x) * std::sin(k * pi * p.y);
  }
};
constexpr SpatialMode modes[] = {{1, 1, 1}, {2, 1, 0.25}};

double start_at(fem::Point p) { return modes[0].at(p) + modes[1].at(p); }

/// 0 divisions: of the equation, else of the elements (the five-point star).
double eigenvalue(const SpatialMode& mode, std::size_t divisions) {
  if (divisions == 0) return pi * pi * (mode.j * mode.j + mode.k * mode.k);
  const auto n = static_cast<double>(divisions);
  const double s = std::sin(mode.j * pi / (2 * n)), t = std::sin(mode.k * pi / (2 * n));
  return 4 * n * n * (s * s + t * t);
}

std::vector<double> exact(const Equation& equation, const Field& field, std::size_t divisions) {
  std::vector<double> u(field.system().size());
  for (const SpatialMode& mode : modes) {
    const double value = eigenvalue(mode, divisions), t = equation.horizon;
    const double factor = equation.wave ? std::cos(std::sqrt(value) * t) : std::exp(-value * t);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] += factor * mode.at(field.system().nodes[i]);
  }
  return u;
}

/// Powers of two, from 4 or the first that is stable.
std::vector<std::size_t> step_counts(const Equation& equation, const Solver& solver,
                                     std::size_t divisions) {
  // Orders in the step are measured on 16 divisions; beyond, the mesh's error remains.
  const std::size_t most = divisions > 16 ? 512 : 1024, of_explicit = 6;
  std::vector<std::size_t> counts;
  if (solver.limit == 0) {
    for (std::size_t steps = 4; steps <= most; steps *= 2) counts.push_back(steps);
    return counts;
  }
  const auto n = static_cast<double>(divisions);
  const double highest = 8 * n * n * std::pow(std::cos(pi / (2 * n)), 2);
  const double largest = solver.limit / (equation.wave ? std::sqrt(highest) : highest);
  std::size_t steps = 4;
  while (equation.horizon / static_cast<double>(steps) > largest) steps *= 2;
  for (std::size_t k = 0; k < of_explicit; ++k, steps *= 2) counts.push_back(steps);
  return counts;
}

struct Task {
  const Equation* equation;
  std::size_t divisions;
};

/// Every solver with every number of steps on one mesh.
EvolutionResult run_mesh(const Task& task) {
  const Equation& equation = *task.equation;
  const Field field(equation.wave, task.divisions, fem::Mass::lumped, false, start_at);
  const std::vector<double> of_equation = exact(equation, field, 0),
                            of_elements = exact(equation, field, task.divisions);
  const double size = field.norm(of_equation);
  const auto distance = [&](std::vector<double> u, const std::vector<double>& to) {
    for (std::size_t i = 0; i < to.size(); ++i) u[i] -= to[i];
    return field.norm(u) / size;
  };
  EvolutionResult result;
  for (const Solver& solver : equation.solvers)
    for (const std::size_t steps : step_counts(equation, solver, task.divisions)) {
      if (interrupted) throw Interrupted();
      EvolutionRow& row = result.runs.emplace_back();
      row.problem = equation.id, row.solver = solver.id;
      row.divisions = task.divisions, row.unknowns = field.system().size();
      row.steps = steps, row.dt = equation.horizon / static_cast<double>(steps);
      row.error_space = distance(of_elements, of_equation);
      const std::vector<double> u = field.after(solver.id, equation.horizon, steps, &row.detail);
      row.status = u.empty() ? "failed" : "ok", row.work = field.work();
      if (u.empty()) continue;
      row.error = distance(u, of_equation), row.error_time = distance(u, of_elements);
    }
  return result;
}

judge::ErrorPoint point(double step, double error, std::size_t steps) {
  // Errors are relative to the solution.
  return {.step = step,
          .error = error,
          .steps = static_cast<double>(steps),
          .rounding_unit = std::numeric_limits<double>::epsilon(),
          .scale = 1};
}

/// The mesh on which orders in the step are measured: the largest of 16 or below.
std::size_t mesh_of_steps(const std::vector<EvolutionRow>& runs) {
  std::size_t divisions = 0;
  for (const EvolutionRow& row : runs)
    if (row.divisions <= 16) divisions = std::max(divisions, row.divisions);
  return divisions;
}

EvolutionOrderRow order_of(const Equation& equation, const Solver& solver, const char* direction,
                           double claimed, const std::vector<judge::ErrorPoint>& points) {
  EvolutionOrderRow row;
  row.problem = equation.id, row.solver = solver.id, row.direction = direction;
  row.claimed_order = claimed;
  row.fit = judge::fit_order(points, claimed, judge::fixed_step_tolerance(claimed));
  return row;
}

/// Adds the orders. In time: the error of the steps alone. In space: the whole error on each mesh,
/// with the most steps, where these contribute less than a twentieth; solvers of order 1 do not
/// come so far.
void add_orders(EvolutionResult& result, const Equation& equation, const Solver& solver) {
  const std::size_t divisions = mesh_of_steps(result.runs);
  std::vector<judge::ErrorPoint> in_time, in_space;
  for (const EvolutionRow& row : result.runs) {
    if (row.problem != equation.id || row.solver != solver.id || row.status != "ok") continue;
    if (row.divisions == divisions) in_time.push_back(point(row.dt, row.error_time, row.steps));
    if (row.error_time > 0.05 * row.error_space) continue;
    const double h = 1 / static_cast<double>(row.divisions);
    if (!in_space.empty() && in_space.back().step == h) in_space.pop_back();
    in_space.push_back(point(h, row.error, row.steps));
  }
  result.orders.push_back(order_of(equation, solver, "time", solver.order, in_time));
  if (solver.order > 1) result.orders.push_back(order_of(equation, solver, "space", 2, in_space));
}

void add_cheapest(EvolutionResult& result, const Equation& equation, const Solver& solver) {
  for (const double target : {1e-2, 1e-3, 1e-4}) {
    EvolutionCheapestRow& best = result.cheapest.emplace_back();
    best.problem = equation.id, best.solver = solver.id, best.status = "not_reached";
    best.target = target;
    for (const EvolutionRow& row : result.runs) {
      if (row.problem != best.problem || row.solver != best.solver || !(row.error <= target) ||
          (best.status == "ok" && row.work >= best.work))
        continue;
      best.status = "ok", best.divisions = row.divisions, best.steps = row.steps;
      best.h = 1 / static_cast<double>(row.divisions), best.dt = row.dt;
      best.error = row.error, best.work = row.work;
    }
  }
}

}  // namespace

EvolutionResult measure_evolution(const Options& options, const Runner& runner) {
  const auto most = static_cast<std::size_t>(options.number(evolution_divisions));
  std::vector<Task> tasks;
  for (const Equation& equation : equations)
    for (std::size_t n = 4; n <= most; n *= 2) tasks.push_back({&equation, n});
  EvolutionResult result = runner.run(
      "evolution", tasks,
      [](const Task& task) { return fmt::format("{} {}", task.equation->id, task.divisions); },
      run_mesh);
  for (const Equation& equation : equations)
    for (const Solver& solver : equation.solvers) {
      add_orders(result, equation, solver);
      add_cheapest(result, equation, solver);
    }
  record::append(result, measure_modes());
  return result;
}

}  // namespace odeum::study
