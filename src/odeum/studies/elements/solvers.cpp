// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <random>

#include "odeum/linear/eigen_solvers.hpp"
#include "odeum/linear/iterative_solvers.hpp"
#include "odeum/studies/elements/problems.hpp"
#include "odeum/studies/elements/rows.hpp"

namespace odeum::study {
namespace {

using linear::SparseMatrix;
constexpr double reduction = 1e-8;  // of the energy norm of the error
constexpr std::size_t largest = 64;

/// Energy norm of a - b.
double energy_distance(const SparseMatrix& matrix, std::vector<double> a, const double* b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] -= b[i];
  return linear::energy_norm(matrix, a);
}

/// A system with a known solution in which every eigenvector takes part.
struct Trial {
  const SparseMatrix& a;
  std::vector<double> solution, b;
  double energy;

  explicit Trial(const SparseMatrix& matrix) : a(matrix), solution(matrix.rows), b(matrix.rows) {
    std::mt19937_64 bits(16);
    for (double& each : solution) each = static_cast<double>(bits() >> 11) * 0x1p-52 - 1;
    a.multiply(solution.data(), b.data());
    energy = linear::energy_norm(a, solution);
  }
  /// Energy norm of the error of x, against that of the guess 0.
  double error(const double* x) const { return energy_distance(a, solution, x) / energy; }
  /// |b - A x| / |b|
  double residual(const std::vector<double>& x) const {
    return linear::residual_norm(a, x, b) /
           linear::residual_norm(a, std::vector<double>(b.size()), b);
  }
};

/// The preconditioners of one system, and the ends of the spectrum of M^-1 A for each.
struct Tools {
  struct Preconditioned {
    std::unique_ptr<linear::Preconditioner> m;
    double lowest, highest;
    double condition() const { return highest / lowest; }
    /// Spectral radius of I - M^-1 A, whose energy norm it is too, for M is symmetric.
    double radius() const { return std::max(std::abs(1 - lowest), std::abs(1 - highest)); }
  };
  Preconditioned none, jacobi, ssor, cholesky, multigrid;

  Tools(const Trial& trial, const Hierarchy& hierarchy)
      : none(make(trial, std::make_unique<linear::NoPreconditioner>(trial.a))),
        jacobi(make(trial, std::make_unique<linear::JacobiPreconditioner>(trial.a))),
        ssor(make(trial, std::make_unique<linear::SsorPreconditioner>(trial.a))),
        cholesky(make(trial, std::make_unique<linear::IncompleteCholesky>(trial.a))),
        multigrid(make(trial, std::make_unique<linear::Multigrid>(hierarchy.multigrid()))) {}

 private:
  static Preconditioned make(const Trial& trial, std::unique_ptr<linear::Preconditioner> m) {
    // At this residual the ends of Lanczos' spectrum have converged: tests compare them with closed
    // forms.
    const linear::CgOutcome run =
        linear::preconditioned_cg(trial.a, *m, trial.b, {.relative_residual = 1e-13});
    return {std::move(m), run.lowest, run.highest};
  }
};

/// What theory says of an iteration: |e_k| <= factor rate^k |e_0| in the energy norm.
struct Bound {
  double rate = 0, factor = 1;
  double iterations() const {
    return rate < 1 ? std::ceil(std::log(reduction / factor) / std::log(rate)) : nan;
  }
};
Bound cg_bound(double condition) {
  const double root = std::sqrt(condition);
  return {(root - 1) / (root + 1), 2};
}

using Run = std::function<linear::IterativeOutcome(const linear::StopRule&, const linear::Watch&)>;

void measure(ElementsSolverRow& row, const Trial& trial, const Bound& bound, const Run& run) {
  std::vector<double> errors{1};
  const linear::IterativeOutcome outcome =
      run({.relative_residual = 1e-15}, [&](std::size_t, const double* x) {
        if (interrupted) throw Interrupted();
        errors.push_back(trial.error(x));
        return errors.back() > reduction;
      });
  const bool done = errors.back() <= reduction;
  row.status = done ? "ok" : to_string(outcome.status);
  row.iterations = outcome.iterations;
  row.residual = trial.residual(outcome.x);
  const std::size_t last = errors.size() - 1, half = last / 2;
  if (last > half)
    row.rate = std::pow(errors[last] / errors[half], 1 / static_cast<double>(last - half));
  row.bound = bound.rate, row.iterations_bound = bound.iterations();
  if (outcome.status == linear::IterationStatus::diverged)
    row.detail = fmt::format("the spectral radius of its iteration is {:.3f}", row.spectral_radius);
  else if (done && static_cast<double>(row.iterations) > row.iterations_bound)
    row.status = "beyond_bound", row.detail = "more iterations than the bound allows";
}

/// Peers show no iterate: the least number of iterations that suffices, since the energy norm of
/// the error falls with each.
void measure_peer(ElementsSolverRow& row, const Trial& trial, const linear::LinearPeerInfo& info) {
  const std::unique_ptr<linear::LinearPeer> peer = info.set_up(trial.a);
  std::vector<double> x;
  const auto error_after = [&](std::size_t iterations) {
    if (interrupted) throw Interrupted();
    peer->solve(trial.b, x, 0, iterations);
    return trial.error(x.data());
  };
  std::size_t low = 0, high = info.direct ? 0 : 1;
  const std::size_t most = trial.b.size() + 50;
  while (high > 0 && high < most && error_after(high) > reduction) low = high, high *= 2;
  while (high - low > 1) {
    const std::size_t half = (low + high) / 2;
    (error_after(half) > reduction ? low : high) = half;
  }
  const bool done = error_after(high) <= reduction;
  row.status = done ? "ok" : info.direct ? "inaccurate" : "over_budget";
  if (info.direct) row.detail = "direct";
  row.iterations = high;
  row.residual = trial.residual(x);
}

struct Size {
  const ModelProblem* model;
  std::size_t divisions;
};

/// Every solver on one system.
class Systems {
 public:
  explicit Systems(const Size& size)
      : hierarchy_(*size.model, size.divisions),
        trial_(hierarchy_.finest().system.matrix),
        tools_(trial_, hierarchy_),
        size_(size) {}

  std::vector<ElementsSolverRow> rows() {
    stationary("jacobi", tools_.jacobi);
    // The square of the norm of a forward sweep is that of the symmetric sweep.
    add("odeum/gauss_seidel", {std::sqrt(1 - tools_.ssor.lowest)},
        [this](const auto& rule, const auto& watch) {
          return linear::gauss_seidel(trial_.a, trial_.b, rule, watch);
        });
    const double condition = tools_.none.condition();
    add("odeum/steepest_descent", {(condition - 1) / (condition + 1)},
        [this](const auto& rule, const auto& watch) {
          return linear::steepest_descent(trial_.a, trial_.b, rule, watch);
        });
    rows_.back().condition = condition;
    gradients("cg", tools_.none), gradients("pcg_jacobi", tools_.jacobi);
    gradients("pcg_ssor", tools_.ssor), gradients("pcg_ic0", tools_.cholesky);
    gradients("pcg_multigrid", tools_.multigrid), stationary("multigrid", tools_.multigrid);
    for (const linear::LinearPeerInfo& peer : linear::linear_peers())
      measure_peer(next(peer.id), trial_, peer);
    return std::move(rows_);
  }

 private:
  ElementsSolverRow& next(const std::string& solver) {
    ElementsSolverRow& row = rows_.emplace_back();
    row.problem = size_.model->id, row.solver = solver;
    row.divisions = size_.divisions, row.unknowns = trial_.b.size();
    return row;
  }
  void add(const std::string& solver, const Bound& bound, const Run& run) {
    measure(next(solver), trial_, bound, run);
  }
  void stationary(const std::string& name, const Tools::Preconditioned& tool) {
    ElementsSolverRow& row = next("odeum/" + name);
    row.condition = tool.condition(), row.spectral_radius = tool.radius();
    measure(row, trial_, {tool.radius()}, [&](const auto& rule, const auto& watch) {
      return linear::stationary(trial_.a, *tool.m, trial_.b, rule, watch);
    });
  }
  void gradients(const std::string& name, const Tools::Preconditioned& tool) {
    ElementsSolverRow& row = next("odeum/" + name);
    row.condition = tool.condition();
    measure(row, trial_, cg_bound(tool.condition()), [&](const auto& rule, const auto& watch) {
      return linear::preconditioned_cg(trial_.a, *tool.m, trial_.b, rule, watch);
    });
  }

  Hierarchy hierarchy_;
  Trial trial_;
  Tools tools_;
  Size size_;
  std::vector<ElementsSolverRow> rows_;
};

/// Errors in the energy norm, which for a = I is the H1 error, of solvers that stop at 1e-1,
/// 1e-2...
std::vector<ElementsStoppingRow> stop_early(std::size_t divisions) {
  const ModelProblem model = smooth_problem();
  const Hierarchy hierarchy(model, divisions);
  const auto& [mesh, system] = hierarchy.finest();
  const auto h1_of = [&, &of = mesh, &by = system](const std::vector<double>& x) {
    return fem::field_errors(of, by.nodal(x), model.value, model.gradient).h1;
  };
  std::vector<double> exact(system.right.size());
  linear::SparseLdlt(system.matrix).solve(system.right.data(), exact.data());
  const Trial trial(system.matrix);
  const Tools tools(trial, hierarchy);
  std::vector<ElementsStoppingRow> rows;
  for (const auto& [name, tool] : {std::pair{"cg", &tools.none},
                                   {"pcg_ic0", &tools.cholesky},
                                   {"pcg_multigrid", &tools.multigrid}})
    for (int digits = 1; digits <= 10; ++digits) {
      ElementsStoppingRow& row = rows.emplace_back();
      row.problem = model.id, row.solver = std::string("odeum/") + name;
      row.divisions = hierarchy.finest_divisions(), row.unknowns = exact.size();
      row.tolerance = std::pow(10, -digits);
      const linear::CgOutcome run = linear::preconditioned_cg(system.matrix, *tool->m, system.right,
                                                              {.relative_residual = row.tolerance});
      row.iterations = run.iterations, row.discretisation = h1_of(exact), row.total = h1_of(run.x);
      row.algebraic = energy_distance(system.matrix, exact, run.x.data());
    }
  return rows;
}

}  // namespace

ElementsResult measure_solvers(std::size_t most, const Runner& runner) {
  const ModelProblem smooth = smooth_problem(), skewed = skewed_problem();
  std::vector<Size> sizes;
  for (std::size_t n = 16; n <= std::min(most, largest); n *= 2) sizes.push_back({&smooth, n});
  if (most >= 32) sizes.push_back({&skewed, 32});
  ElementsResult result = runner.run(
      "solvers", sizes,
      [](const Size& size) { return fmt::format("{} {}", size.model->id, size.divisions); },
      [](const Size& size) { return ElementsResult{.solvers = Systems(size).rows()}; });
  record::append(result,
                 runner.run(
                     "stopping", std::vector{std::min(most, largest)},
                     [](std::size_t n) { return std::to_string(n); },
                     [](std::size_t n) { return ElementsResult{.stopping = stop_early(n)}; }));
  return result;
}

}  // namespace odeum::study
