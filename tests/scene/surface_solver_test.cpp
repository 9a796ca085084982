// SPDX-License-Identifier: BSD-3-Clause
// The linear systems of implicit steps on surfaces that meet.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/read/reader.hpp"

namespace odeum::surface_solver_test {
namespace {

using scene::Scene;
using scene::SceneProblem;

// A sheet of 12 x 12 of which one half lies on the other.
Scene folded(const char* contact) {
  Scene scene = scene::read_scene("s.yaml", std::string(R"(
duration: 1
solver: {type: rk4, timestep: 0.001}
cloth:
  - rows: 12
    columns: 12
    row_edge: [1, 0, 0]
    column_edge: [0, 1, 0]
    mass: 0.2
    structural: {stiffness: 100}
    shear: {stiffness: 60}
    fixed: [{row: 0, column: 3}]
    self_contact: {thickness: 0.05, stiffness: 200)") +
                                                contact + "}\n")
                    .scene;
  for (scene::Particle& particle : scene.particles) {
    double& x = particle.position[0];
    if (x <= 0.5) continue;
    x = 1.01 - x;
    particle.position[1] += 0.02;
    particle.position[2] = 0.03;
  }
  return scene;
}

// (I - g J) x of what was solved is the right-hand side, with J by jacobian_times. Conjugate
// gradients end at 1e-12 of the norm of A x_v = M r_v + g K r_q, some 20 N, beside masses of a
// gram.
void expect_solved(const SceneProblem& problem, double g, ShiftedSolver& solver, double relative) {
  const std::size_t size = problem.size();
  const double* const y = problem.start().data();
  std::vector<double> right(size), x(size), product(size);
  for (std::size_t i = 0; i < size; ++i) right[i] = std::sin(1.0 + 3.0 * static_cast<double>(i));
  x = right;
  ASSERT_TRUE(solver.factorise(0, y, g));
  ASSERT_TRUE(solver.solve(x.data(), ShiftedSolver::exact));
  problem.jacobian_times(0, y, x.data(), product.data());
  for (std::size_t i = 0; i < size; ++i)
    EXPECT_NEAR(x[i] - g * product[i], right[i], relative) << i;
}

// On a grid by conjugate gradients. Where steps are so long that pairs that are pushed apart make
// the matrix indefinite, and with friction, directly.
TEST(SurfaceSolver, SystemsOfStepsAreSolved) {
  const SceneProblem problem(folded(""));
  ASSERT_TRUE(problem.grid());
  const auto solver = problem.shifted_solver();
  expect_solved(problem, 0.001, *solver, 1e-8);
  const std::uint64_t products = solver->products();
  EXPECT_GT(products, 3U);
  EXPECT_LT(products, 40U);
  expect_solved(problem, 0.05, *solver, 1e-6);
  const SceneProblem with_friction(folded(", friction: 0.2"));
  const auto directly = with_friction.shifted_solver();
  expect_solved(with_friction, 0.001, *directly, 1e-8);
  EXPECT_GT(directly->products(), products) << "what the factors cost";
}

// For methods whose order does not depend on J the pairs have a semidefinite part alone.
TEST(SurfaceSolver, OneSystemAStepIsPositiveDefiniteAtAnyStep) {
  const SceneProblem problem(folded(""));
  const auto solver = problem.shifted_solver();
  solver->solve_once_a_step();
  for (const double g : {0.001, 0.1, 1.0}) {
    std::vector<double> x(problem.size(), 1.0);
    ASSERT_TRUE(solver->factorise(0, problem.start().data(), g));
    const std::uint64_t before = solver->products();
    ASSERT_TRUE(solver->solve(x.data(), 1e-6)) << g;
    EXPECT_GT(solver->products(), before);
    for (const double number : x) ASSERT_TRUE(std::isfinite(number));
  }
}

}  // namespace
}  // namespace odeum::surface_solver_test
