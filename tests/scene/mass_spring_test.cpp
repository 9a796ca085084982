// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/problem/scene_problem.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/scenes.hpp"

namespace odeum::tests::mass_spring_test {
namespace {

using Vector = Eigen::VectorXd;
using scene::Scene;
using scene::SceneProblem;
using scene::Spring;

Vector rhs(const SceneProblem& problem, const Vector& y) {
  Vector dydt(y.size());
  problem.rhs(0, y.data(), dydt.data());
  return dydt;
}

Vector start(const Scene& scene) {
  const std::vector<double> y = start_of(scene);
  return Eigen::Map<const Vector>(y.data(), static_cast<Eigen::Index>(y.size()));
}

TEST(SceneProblem, JacobianTimesIsTheDerivativeOfTheRightHandSide) {
  const Scene scene = disordered_net(4, 0.08, 2);
  const SceneProblem problem(scene);
  const Vector y = start(scene);
  std::srand(3);
  for (int trial = 0; trial < 5; ++trial) {
    const Vector x = Vector::Random(y.size());
    Vector product(y.size());
    problem.jacobian_times(0, y.data(), x.data(), product.data());
    const double delta = 1e-6;
    const Vector difference =
        (rhs(problem, y + delta * x) - rhs(problem, y - delta * x)) / (2 * delta);
    // Rounding of f (size 1e2) over delta: 1e-8. Truncation: delta^2 f''' / 6 with f''' up to
    // k / (m l^2) = 1e4: 1e-9. No spring is within 1e-5 of its kink.
    EXPECT_LE((product - difference).norm(), 1e-7 * product.norm());
  }
}

TEST(SceneProblem, EnergyFallsByWhatTheDampersTake) {
  const Scene scene = disordered_net(4, 0.08, 2);
  const SceneProblem problem(scene);
  const Vector y = start(scene), slope = rhs(problem, y);
  const double delta = 1e-6;
  const Vector after = y + delta * slope, before = y - delta * slope;
  const double rate = (problem.energy(after.data()) - problem.energy(before.data())) / (2 * delta);
  double power = 0;
  for (const Spring& spring : scene.springs)
    for (std::size_t d = 0; d < 3; ++d) {
      const auto& [va, vb] =
          std::pair{scene.particles[spring.a].velocity, scene.particles[spring.b].velocity};
      power += spring.damping * (vb[d] - va[d]) * (vb[d] - va[d]);
    }
  EXPECT_GT(power, 1e-3);
  // Rounding of the energy (about 10 J, a hundred terms) over delta: 1e-8.
  EXPECT_NEAR(rate, -power, 1e-7);
}

TEST(SceneProblem, KeepsMomentumAndWithoutDampersAngularMomentum) {
  for (const double damping : {0.0, 0.5}) {
    Scene scene = disordered_net(4, 0.08, 0, 10, damping);
    scene.gravity = {};
    const SceneProblem problem(scene);
    const Vector y = start(scene);
    const auto n = y.size() / 2;
    const Vector a = rhs(problem, y).tail(n);
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), torque = force;
    double size = 0;
    for (Eigen::Index i = 0; i < n / 3; ++i) {
      const Eigen::Vector3d f =
          scene.particles[static_cast<std::size_t>(i)].mass * a.segment<3>(3 * i);
      force += f;
      torque += y.segment<3>(3 * i).cross(f);
      size += f.norm();
    }
    EXPECT_GT(size, 1);
    EXPECT_LE(force.norm(), 1e-14 * size);  // sums of a hundred terms: some ten roundings
    if (damping == 0)
      EXPECT_LE(torque.norm(), 1e-14 * size);
    else  // dampers act on the whole relative velocity, not only along the spring
      EXPECT_GT(torque.norm(), 1e-6);
  }
}

TEST(SceneProblem, FixedParticlesFeelNothingAndFreeOnesFall) {
  Scene scene;
  scene.gravity = {0, -9.8, 1};
  scene.particles = {{.position = {0, 0, 0}, .fixed = true}, {.position = {5, 0, 0}, .mass = 3}};
  const SceneProblem problem(scene);
  const Vector slope = rhs(problem, start(scene));
  EXPECT_EQ(slope.head(6), Vector::Zero(6));
  EXPECT_EQ(slope.segment<3>(6), Eigen::Vector3d::Zero());
  EXPECT_EQ(slope.segment<3>(9), Eigen::Vector3d(0, -9.8, 1));
}

/// A free particle of mass 2 at x, moving, tied to a fixed one at the origin.
Scene tied(double x, const Spring& spring) {
  Scene scene;
  scene.particles = {{.fixed = true}, {.position = {x, 0, 0}, .velocity = {0, 1, 0}, .mass = 2}};
  scene.springs = {spring};
  return scene;
}

TEST(SceneProblem, ASpringObeysItsLawAndASlackOneOnlyDamps) {
  const Spring two_way{.a = 0, .b = 1, .stiffness = 10, .damping = 4, .rest_length = 1};
  Spring tension = two_way;
  tension.tension_only = true;
  struct Expected {
    Spring spring;
    double x = 0, acceleration = 0, energy = 0;
  };
  for (const auto& [spring, x, acceleration, energy] :
       {Expected{two_way, 1.5, -2.5, 1.25}, Expected{two_way, 0.5, 2.5, 1.25},
        Expected{tension, 1.5, -2.5, 1.25}, Expected{tension, 0.5, 0, 0},
        Expected{tension, 1, 0, 0}, Expected{two_way, 0, 0, 5}}) {
    const Scene scene = tied(x, spring);
    const SceneProblem problem(scene);
    const Vector y = start(scene), slope = rhs(problem, y);
    EXPECT_DOUBLE_EQ(slope[9], acceleration) << "x = " << x;
    EXPECT_DOUBLE_EQ(slope[10], -2) << "damping on the relative velocity, slack or not";
    EXPECT_DOUBLE_EQ(problem.energy(y.data()), 1 + energy) << "with 1 J of motion";
  }
}

TEST(SceneProblem, RefusesScenesThatItCannotModel) {
  const Spring spring{.a = 0, .b = 1, .stiffness = 1};
  EXPECT_NO_THROW(SceneProblem(tied(1, spring)));
  EXPECT_THROW(SceneProblem(tied(1, {.a = 0, .b = 2})), std::invalid_argument);
  EXPECT_THROW(SceneProblem(tied(1, {.a = 1, .b = 1})), std::invalid_argument);
  for (const double mass : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    Scene scene = tied(1, spring);
    scene.particles[1].mass = mass;
    EXPECT_THROW(SceneProblem{scene}, std::invalid_argument) << mass;
    scene.particles[1].fixed = true;
    scene.particles[1].velocity = {};
    EXPECT_NO_THROW(SceneProblem{scene}) << "a fixed particle's mass is of no account";
  }
  Scene moving = tied(1, spring);
  moving.particles[0].velocity = {1, 0, 0};
  EXPECT_THROW(SceneProblem{moving}, std::invalid_argument);
  Scene medium = tied(1, spring);
  medium.velocity_matrix[0] = -1;
  EXPECT_THROW(SceneProblem{medium}, std::invalid_argument);
}

}  // namespace
}  // namespace odeum::tests::mass_spring_test
