// SPDX-License-Identifier: BSD-3-Clause
// The terms of a scene: their derivatives, conservation laws, and that undeclared terms are absent.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "odeum/cases/scene_case.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/read/reader.hpp"
#include "support/scene_texts.hpp"

namespace odeum::scene_terms_test {
namespace {

using scene::Scene;
using scene::SceneProblem;
using scene::Vec3;
using tests::with_particles;

Scene read(const std::string& text) { return scene::read_scene("s.yaml", text).scene; }

// Four particles close together, one of them fixed, that every term acts on.
const char* const crowd = R"(
duration: 1
solver: {type: rk4, timestep: 0.01}
particles:
  - {pos: [0, 0, 0.01], vel: [0.3, -0.2, -0.1], mass: 1, radius: 0.3}
  - {pos: [0.5, 0.1, 0.02], vel: [-0.4, 0.1, 0.2], mass: 0.5, radius: 0.3}
  - {pos: [0.2, 0.4, -0.1], vel: [0.1, 0.6, -0.3], mass: 2, radius: 0.2}
  - {pos: [0.4, 0.5, 0.6], mass: 1, fixed: true, radius: 0.3}
)";

struct TermCase {
  const char* name;
  const char* text;
  friend std::ostream& operator<<(std::ostream& out, const TermCase& x) { return out << x.name; }
};
class SceneTerm : public testing::TestWithParam<TermCase> {};

// Central differences of the acceleration at d = 1e-6: truncation d^2 times a third derivative (of
// friction: up to 1 / friction_speed^2), rounding eps |a| / d; both under 1e-5 of the scale here.
TEST_P(SceneTerm, ItsDerivativeIsThatOfItsForce) {
  const SceneProblem problem(read(crowd + std::string(GetParam().text)));
  const std::size_t size = problem.size(), half = size / 2;
  std::vector<double> y = problem.start(), x(size), product(size), high(half), low(half);
  for (std::size_t i = 0; i < size; ++i) x[i] = std::sin(1.0 + 3.0 * static_cast<double>(i));
  problem.jacobian_times(0, y.data(), x.data(), product.data());
  const double d = 1e-6;
  const auto at = [&](double sign, std::vector<double>& a) {
    std::vector<double> moved = y;
    for (std::size_t i = 0; i < size; ++i) moved[i] += sign * d * x[i];
    problem.acceleration(0, moved.data(), moved.data() + half, a.data());
  };
  at(1, high);
  at(-1, low);
  double scale = 0;
  for (std::size_t i = 0; i < half; ++i) scale = std::max(scale, std::abs(product[half + i]));
  EXPECT_GT(scale, 0.01) << "the term acts here";
  for (std::size_t i = 0; i < half; ++i) {
    EXPECT_NEAR(product[half + i], (high[i] - low[i]) / (2 * d), 1e-5 * scale) << i;
    EXPECT_EQ(product[i], x[half + i]);
  }
}

// (I - g J) x = r, checked by putting the solution back.
TEST_P(SceneTerm, ShiftedSystemsAreSolved) {
  const SceneProblem problem(read(crowd + std::string(GetParam().text)));
  const std::size_t size = problem.size();
  std::vector<double> r(size), x, jx(size);
  for (std::size_t i = 0; i < size; ++i) r[i] = std::cos(2.0 * static_cast<double>(i));
  x = r;
  const auto solver = problem.shifted_solver();
  const double g = 0.013;
  ASSERT_TRUE(solver->factorise(0, problem.start().data(), g));
  ASSERT_TRUE(solver->solve(x.data(), ShiftedSolver::exact));
  problem.jacobian_times(0, problem.start().data(), x.data(), jx.data());
  for (std::size_t i = 0; i < size; ++i)
    EXPECT_NEAR(x[i] - g * jx[i], r[i], 1e-9) << i;  // conjugate gradients stop at 1e-12
}

INSTANTIATE_TEST_SUITE_P(
    Scene, SceneTerm,
    testing::Values(
        TermCase{"full_springs",
                 "gravity: 0\nsprings: [{particle_ids: [0, 1], stiffness: 7, "
                 "damping: 0.4, damping_model: full, rest_length: 0.3}]\n"},
        TermCase{"axial_springs",
                 "springs: [{particle_ids: [0, 1], stiffness: 7, damping: 0.4, rest_length: 0.3}, "
                 "{particle_ids: [2, 3], stiffness: 3, damping: 0.2, rest_length: 0.9}]\n"},
        TermCase{"tension_only",
                 "springs: [{particle_ids: [0, 1], stiffness: 7, damping: 0.4, "
                 "rest_length: 0.9, tension_only: true}]\n"},
        TermCase{"gravitation",
                 "gravitational: [{particle_ids: [0, 1], G: 0.7}, {particle_ids: [3, 2], G: 2}]\n"},
        TermCase{"drag", "forces: [{drag: {coefficient: 0.7}}]\n"},
        TermCase{"quadratic_drag", "forces: [{quadratic_drag: {coefficient: 0.7}}]\n"},
        TermCase{"wind", "forces: [{wind: {velocity: [1, 2, 3], coefficient: 0.7}}]\n"},
        TermCase{"magnetic", "forces: [{magnetic: {field: [1, 2, 3], charge: 0.7}}]\n"},
        TermCase{"plane",
                 "contacts: [{plane: {point: [0, 0, 0], normal: [0.1, 0, 1], stiffness: "
                 "50, damping: 2, friction: 0.4}}]\n"},
        TermCase{"sphere",
                 "contacts: [{sphere: {center: [0, 0, -0.5], radius: 0.4, stiffness: 50, "
                 "damping: 2, friction: 0.4}}]\n"},
        TermCase{"particles",
                 "contacts: [{particles: {stiffness: 50, damping: 2, friction: 0.4}}]\n"}),
    [](const auto& term) { return term.param.name; });

TEST(SceneTerms, AProblemHasTheTermsThatItsSceneDeclaresAndNoOthers) {
  EXPECT_TRUE(SceneProblem(read(with_particles(""))).structure().terms.empty());
  const SceneProblem dragged(read(with_particles("forces: [{drag: {coefficient: 1}}]\n")));
  ASSERT_EQ(dragged.structure().terms.size(), 1U);
  EXPECT_EQ(dragged.structure().terms[0].name, "drag");
}

TEST(SceneTerms, AFarAwaySurfaceChangesNoBit) {
  const std::string springs = "springs: [{particle_ids: [0, 1], stiffness: 5, damping: 0.1}]\n";
  const SceneProblem bare(read(crowd + springs));
  const SceneProblem walled(read(
      crowd + springs +
      "contacts: [{plane: {point: [0, 0, -9], normal: [0, 0, 1], stiffness: 1e4, damping: 10}},"
      " {sphere: {center: [9, 0, 0], radius: 1, stiffness: 1e4, friction: 1}}]\n"));
  std::vector<double> y = bare.start(), a(y.size() / 2), b(y.size() / 2);
  for (std::size_t i = 0; i < a.size(); ++i) y[i] += 1e-3 * std::sin(static_cast<double>(i));
  bare.acceleration(0, y.data(), y.data() + a.size(), a.data());
  walled.acceleration(0, y.data(), y.data() + a.size(), b.data());
  EXPECT_EQ(a, b);
  EXPECT_EQ(bare.potential(y.data()), walled.potential(y.data()));
}

// Two of the terms act between particles: forces are equal and opposite, to rounding.
TEST(SceneTerms, InternalForcesKeepMomentum) {
  const SceneProblem problem(
      read("gravity: 0\nduration: 1\nsolver: {type: rk4, timestep: 0.01}\nparticles:\n"
           "  - {pos: [0, 0, 0], vel: [0.3, -0.2, -0.1], mass: 1, radius: 0.3}\n"
           "  - {pos: [0.5, 0.1, 0], vel: [-0.4, 0.1, 0.2], mass: 0.5, radius: 0.3}\n"
           "  - {pos: [0.2, 0.4, -0.1], vel: [0.1, 0.6, -0.3], mass: 2, radius: 0.2}\n"
           "springs: [{particle_ids: [0, 1], stiffness: 7, damping: 0.4, rest_length: 0.2},"
           " {particle_ids: [1, 2], stiffness: 9, damping: 0.4, damping_model: full}]\n"
           "contacts: [{particles: {stiffness: 50, damping: 2, friction: 0.4}}]\n"));
  std::vector<double> rate(problem.size());
  const double* const v = problem.start().data() + rate.size() / 2;
  problem.acceleration(0, problem.start().data(), v, rate.data() + rate.size() / 2);
  double largest = 0;
  for (const double component : rate) largest = std::max(largest, std::abs(component));
  EXPECT_GT(largest, 1);
  const Vec3 force = problem.momentum(rate.data());  // with accelerations in place of velocities
  for (const double component : force) EXPECT_NEAR(component, 0, 1e-14 * largest);
}

TEST(SceneTerms, TheBroadPhaseFindsEveryTouchingPair) {
  scene::Bodies bodies;
  std::vector<double> q;
  for (int i = 0; i < 300; ++i) {
    bodies.mass.push_back(1);
    bodies.inverse_mass.push_back(i % 7 ? 1 : 0);
    bodies.radius.push_back(0.02 + 0.03 * (i % 3));
    for (const double factor : {0.37, 0.73, 1.1}) {
      const double x = factor * i;
      q.push_back(x - std::floor(x) - 0.5);
    }
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  scene::possible_contacts(bodies, q.data(), pairs);
  EXPECT_LT(pairs.size(), 300U * 299 / 4) << "most pairs are far apart";
  std::size_t touching = 0;
  for (std::uint32_t i = 0; i < 300; ++i)
    for (std::uint32_t j = i + 1; j < 300; ++j) {
      const double distance =
          std::hypot(q[3 * i] - q[3 * j], q[3 * i + 1] - q[3 * j + 1], q[3 * i + 2] - q[3 * j + 2]);
      if (distance >= bodies.radius[i] + bodies.radius[j] || (!bodies.free(i) && !bodies.free(j)))
        continue;
      ++touching;
      EXPECT_TRUE(std::binary_search(pairs.begin(), pairs.end(), std::pair{i, j})) << i << " " << j;
    }
  EXPECT_GT(touching, 50U);
  q[0] = std::nan("");
  q[4] = 1e300;
  scene::possible_contacts(bodies, q.data(), pairs);  // nothing overflows
}

TEST(SceneTerms, TheStructureIsFound) {
  const auto structure = [](const std::string& more) {
    return SceneProblem(read(with_particles(more))).structure();
  };
  EXPECT_TRUE(structure("").closed_form);
  const auto spring = structure("springs: [{particle_ids: [0, 1], stiffness: 5}]\n");
  EXPECT_TRUE(spring.separable && spring.smooth() && !spring.linear && !spring.closed_form);
  EXPECT_EQ(spring.kernel, "edge list");
  EXPECT_TRUE(
      structure("springs: [{particle_ids: [0, 1], stiffness: 5, rest_length: 0}]\n").linear);
  EXPECT_FALSE(
      structure("springs: [{particle_ids: [0, 1], stiffness: 5, damping: 1}]\n").separable);
  EXPECT_TRUE(structure("forces: [{magnetic: {field: [0, 0, 1], charge: 1}}]\n").linear);
  const auto wall =
      structure("contacts: [{plane: {point: [0, 0, 0], normal: [0, 0, 1], stiffness: 1}}]\n");
  EXPECT_TRUE(wall.separable && !wall.smooth() && !wall.linear);
  EXPECT_TRUE(structure("contacts: [{particles: {stiffness: 1}}]\n").terms.empty())
      << "particles without a radius never touch";
  const auto& scenes = cases::all_scenes();
  const auto cloth = std::find_if(scenes.begin(), scenes.end(),
                                  [](const auto& text) { return text.name == "hanging_cloth"; });
  ASSERT_NE(cloth, scenes.end());
  EXPECT_EQ(SceneProblem(read(std::string(cloth->text))).structure().kernel,
            "gather on the regular 20 x 20 grid");
}

}  // namespace
}  // namespace odeum::scene_terms_test
