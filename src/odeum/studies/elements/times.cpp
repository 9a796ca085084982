// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/eigen_solvers.hpp"
#include "odeum/linear/iterative_solvers.hpp"
#include "odeum/studies/elements/problems.hpp"
#include "odeum/studies/elements/rows.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::study {
namespace {

constexpr double residual_tolerance = 1e-8;  // of the residual
constexpr int repetitions = 5;
constexpr double slow_ns = 1e9;  // a solver that takes longer is timed once

/// Solves into x; how many iterations.
using Solve = std::function<std::size_t(std::vector<double>& x)>;
struct Timed {
  std::string solver;
  std::function<Solve()> set_up;
  Times setup = {}, solve = {};
  std::size_t iterations = 0;
  std::vector<double> x = {};
};

Solve gradients(const fem::EllipticSystem& system,
                std::shared_ptr<const linear::Preconditioner> m) {
  return [&system, m = std::move(m)](std::vector<double>& x) {
    linear::CgOutcome run = linear::preconditioned_cg(system.matrix, *m, system.right,
                                                      {.relative_residual = residual_tolerance});
    x = std::move(run.x);
    return run.iterations;
  };
}

std::vector<Timed> solvers(const Hierarchy& hierarchy) {
  const fem::EllipticSystem& system = hierarchy.finest().system;
  const linear::SparseMatrix& a = system.matrix;
  const auto v_cycle = [&] { return std::make_shared<linear::Multigrid>(hierarchy.multigrid()); };
  std::vector<Timed> all{
      {"odeum/cg",
       [&] { return gradients(system, std::make_shared<linear::NoPreconditioner>(a)); }},
      {"odeum/pcg_jacobi",
       [&] { return gradients(system, std::make_shared<linear::JacobiPreconditioner>(a)); }},
      {"odeum/pcg_ssor",
       [&] { return gradients(system, std::make_shared<linear::SsorPreconditioner>(a)); }},
      {"odeum/pcg_ic0",
       [&] { return gradients(system, std::make_shared<linear::IncompleteCholesky>(a)); }},
      {"odeum/pcg_multigrid", [&, v_cycle] { return gradients(system, v_cycle()); }},
      {"odeum/multigrid", [&, v_cycle]() -> Solve {
         return [&system, m = v_cycle()](std::vector<double>& x) {
           linear::IterativeOutcome run = linear::stationary(
               system.matrix, *m, system.right, {.relative_residual = residual_tolerance});
           x = std::move(run.x);
           return run.iterations;
         };
       }}};
  for (const linear::LinearPeerInfo& info : linear::linear_peers())
    all.push_back({info.id, [&]() -> Solve {
                     return [&system, peer = std::shared_ptr<linear::LinearPeer>(info.set_up(a))](
                                std::vector<double>& x) {
                       return peer->solve(system.right, x, residual_tolerance, 100'000);
                     };
                   }});
  return all;
}

}  // namespace

std::vector<ElementsTimeRow> time_solvers(std::size_t most) {
  const ModelProblem model = smooth_problem();
  const Hierarchy hierarchy(model, most);
  const fem::EllipticSystem& system = hierarchy.finest().system;
  std::vector<Timed> all = solvers(hierarchy);
  const Pinned pinned;
  // Interleaved, so that what disturbs the machine for a while disturbs all.
  for (int repetition = 0; repetition < repetitions; ++repetition)
    for (Timed& each : all) {
      if (interrupted) throw Interrupted();
      if (repetition > 0 && each.solve.min() > slow_ns) continue;
      Solve solve;
      each.setup.ns.push_back(time_call([&] { solve = each.set_up(); }, 1e9));
      if (repetition == 0) each.iterations = solve(each.x);
      each.solve.ns.push_back(
          time_call([&] { solve(each.x); }, repetition == 0 ? 1e9 : each.solve.min()));
    }
  const double size =
      linear::residual_norm(system.matrix, std::vector<double>(system.right.size()), system.right);
  std::vector<ElementsTimeRow> rows;
  for (const Timed& each : all) {
    ElementsTimeRow& row = rows.emplace_back();
    row.problem = model.id, row.solver = each.solver, row.divisions = hierarchy.finest_divisions();
    row.unknowns = system.right.size(), row.iterations = each.iterations;
    row.repetitions = each.solve.ns.size(), row.setup_ns = each.setup.min();
    row.solve_ns_min = each.solve.min(), row.solve_ns_median = each.solve.median();
    row.residual = linear::residual_norm(system.matrix, each.x, system.right) / size;
    // The residual that an iteration updates drifts from the true one by rounding.
    row.status = row.residual <= 1.1 * residual_tolerance ? "ok" : "inaccurate";
  }
  return rows;
}

}  // namespace odeum::study
