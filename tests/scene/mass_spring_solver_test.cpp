// SPDX-License-Identifier: BSD-3-Clause
// The matrix-free solver of (I - gamma h J) x = r against dense matrices, and the step of
// linearised implicit Euler that rests on it against its mechanical form.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <ostream>

#include "odeum/methods/implicit_euler_linearised.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "support/scenes.hpp"

namespace odeum::tests::mass_spring_solver_test {
namespace {

using Eigen::Index;
using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;
using scene::Scene;
using scene::SceneProblem;

Matrix dense_jacobian(const SceneProblem& problem, const std::vector<double>& y) {
  const auto n = static_cast<Index>(y.size());
  Matrix j(n, n);
  for (Index column = 0; column < n; ++column) {
    const Vector unit = Vector::Unit(n, column);
    Vector product(n);
    problem.jacobian_times(0, y.data(), unit.data(), product.data());
    j.col(column) = product;
  }
  return j;
}

/// The smallest eigenvalue of M - g D - g^2 K over the free particles (fixed ones show as their 1).
double smallest_eigenvalue(const Scene& scene, const Matrix& j, double g) {
  const Index n = j.rows() / 2;
  Matrix a =
      Matrix::Identity(n, n) - g * j.bottomRightCorner(n, n) - g * g * j.bottomLeftCorner(n, n);
  for (Index i = 0; i < n; ++i) a.row(i) *= scene.particles[static_cast<std::size_t>(i / 3)].mass;
  for (Index i = 0; i < n; ++i)
    if (scene.particles[static_cast<std::size_t>(i / 3)].fixed)
      a.row(i) = a.col(i) = Vector::Unit(n, i);
  EXPECT_LE((a - a.transpose()).norm(), 1e-12 * a.norm()) << "the system is symmetric";
  return Eigen::SelfAdjointEigenSolver<Matrix>(a).eigenvalues()[0];
}

struct Setting {
  const char* name;
  double gamma_h, stiffness, squeeze;
  bool definite;
  friend std::ostream& operator<<(std::ostream& out, const Setting& s) { return out << s.name; }
};

class ShiftedSolverOfANet : public testing::TestWithParam<Setting> {};

TEST_P(ShiftedSolverOfANet, AgreesWithADenseSolve) {
  const auto& [name, gamma_h, stiffness, squeeze, definite] = GetParam();
  Scene scene = disordered_net(4, 0.08, 3, stiffness);
  for (auto& particle : scene.particles)
    for (double& coordinate : particle.position) coordinate *= squeeze;
  for (auto& spring : scene.springs) spring.tension_only = spring.tension_only && definite;
  const SceneProblem problem(scene);
  const std::vector<double> y = start_of(scene);
  const Matrix j = dense_jacobian(problem, y);
  EXPECT_EQ(smallest_eigenvalue(scene, j, gamma_h) > 0, definite) << "the case is what it says";
  const Matrix system = Matrix::Identity(j.rows(), j.cols()) - gamma_h * j;
  const auto solver = problem.shifted_solver();
  ASSERT_TRUE(solver->factorise(0, y.data(), gamma_h));
  std::srand(4);
  for (int trial = 0; trial < 3; ++trial) {     // one factorisation serves several right sides
    const Vector r = Vector::Random(j.rows());  // not zero on fixed particles either
    Vector x = r;
    ASSERT_TRUE(solver->solve(x.data(), ShiftedSolver::exact));
    const Vector exact = system.partialPivLu().solve(r);
    // Conjugate gradients stop at a residual of 1e-12; condition numbers here are up to 1e4.
    EXPECT_LE((x - exact).norm(), 1e-9 * exact.norm());
    EXPECT_LE((system * x - r).norm(), 1e-9 * system.norm() * x.norm());
  }
}

INSTANTIATE_TEST_SUITE_P(, ShiftedSolverOfANet,
                         testing::Values(Setting{"short_step", 1e-3, 10, 1, true},
                                         Setting{"moderate_step", 0.05, 10, 1, true},
                                         Setting{"stiff", 0.05, 1000, 1.5, true},
                                         Setting{"compressed", 0.5, 100, 0.3, false}),
                         [](const auto& setting) { return setting.param.name; });

TEST(SceneShiftedSolver, NeverMakesAFiniteAnswerOfANaN) {
  const Scene scene = disordered_net(3, 0.05, 2);
  const SceneProblem problem(scene);
  for (std::size_t entry = 0; entry < 27; ++entry) {
    std::vector<double> y = start_of(scene);
    y[entry] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_FALSE(problem.shifted_solver()->factorise(0, y.data(), 0.01)) << entry;
  }
}

/// One step of (I - h M^-1 df/dv - h^2 M^-1 df/dx) dv = h M^-1 (f + h df/dx v), dx = h (v + dv),
/// with all matrices written out from the law of a spring.
Vector baraff_witkin_step(const Scene& scene, const Vector& y, double h) {
  const Index n = y.size() / 2;
  Matrix inverse_mass = Matrix::Zero(n, n), k = inverse_mass, d = inverse_mass;
  Vector f = Vector::Zero(n);
  const Eigen::Vector3d gravity(scene.gravity.data());
  for (Index i = 0; i < n / 3; ++i) {
    const auto& particle = scene.particles[static_cast<std::size_t>(i)];
    if (particle.fixed) continue;
    inverse_mass.diagonal().segment<3>(3 * i).setConstant(1 / particle.mass);
    f.segment<3>(3 * i) += particle.mass * gravity;
  }
  const auto add = [](Matrix& m, Index a, Index b, const Eigen::Matrix3d& block) {
    m.block<3, 3>(a, a) -= block, m.block<3, 3>(b, b) -= block;
    m.block<3, 3>(a, b) += block, m.block<3, 3>(b, a) += block;
  };
  for (const auto& spring : scene.springs) {
    const auto a = static_cast<Index>(3 * spring.a), b = static_cast<Index>(3 * spring.b);
    const Eigen::Vector3d along = y.segment<3>(b) - y.segment<3>(a), u = along.normalized();
    Eigen::Vector3d force = spring.damping * (y.segment<3>(n + b) - y.segment<3>(n + a));
    add(d, a, b, spring.damping * Eigen::Matrix3d::Identity());
    if (!spring.tension_only || along.norm() > spring.rest_length) {
      const Eigen::Matrix3d uu = u * u.transpose();
      force += spring.stiffness * (along.norm() - spring.rest_length) * u;
      add(k, a, b,
          spring.stiffness *
              (uu + (1 - spring.rest_length / along.norm()) * (Eigen::Matrix3d::Identity() - uu)));
    }
    f.segment<3>(a) += force;
    f.segment<3>(b) -= force;
  }
  const Vector v = y.tail(n);
  const Matrix left = Matrix::Identity(n, n) - h * inverse_mass * d - h * h * inverse_mass * k;
  const Vector dv = left.partialPivLu().solve(h * inverse_mass * (f + h * k * v));
  Vector next = y;
  next.head(n) += h * (v + dv);
  next.tail(n) += dv;
  return next;
}

TEST(ImplicitEulerLinearised, IsTheMechanicalFormulaOnANet) {
  const Scene scene = disordered_net(4, 0.08, 3, 200);
  const SceneProblem problem(scene);
  for (const double h : {0.001, 0.02}) {
    std::vector<double> y = start_of(scene);
    const Vector before = Eigen::Map<const Vector>(y.data(), static_cast<Index>(y.size()));
    methods::implicit_euler_linearised::Stepper<SceneProblem> stepper(problem);
    ASSERT_EQ(stepper.step(0, h, y), Status::ok);
    const Vector expected = baraff_witkin_step(scene, before, h);
    const Vector after = Eigen::Map<const Vector>(y.data(), static_cast<Index>(y.size()));
    EXPECT_GT((expected - before).norm(), 1e-2) << "the step moves the net";
    // The solver's residual of 1e-12 times condition numbers of up to 1e2.
    EXPECT_LE((after - expected).norm(), 1e-10 * (expected - before).norm()) << "h = " << h;
  }
}

}  // namespace
}  // namespace odeum::tests::mass_spring_solver_test
