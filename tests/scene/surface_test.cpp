// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that meet: the potential between two parts of them, what is near, what passes through.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/read/reader.hpp"
#include "odeum/scene/surface/passing.hpp"
#include "support/scene_texts.hpp"

namespace odeum::surface_test {
namespace {

using scene::Meeting;
using scene::Scene;
using scene::SceneProblem;
using Real = long double;
using Place = scene::Vec<Real>;

Scene read(const std::string& text) { return scene::read_scene("s.yaml", text).scene; }

// Two triangles a few millimetres apart, crossing in projection, and a ball beside them.
const char* const two_triangles = R"(
duration: 1
gravity: 0
solver: {type: rk4, timestep: 0.001}
particles:
  - {pos: [0, 0, 0], vel: [0.1, 0, 0.1], mass: 0.1}
  - {pos: [0.1, 0, 0.001], vel: [0, 0.2, 0], mass: 0.2}
  - {pos: [0, 0.1, 0], mass: 0.1}
  - {pos: [0.02, 0.03, 0.006], vel: [0.3, 0.1, -0.2], mass: 0.1}
  - {pos: [0.12, 0.04, 0.007], mass: 0.3}
  - {pos: [0.03, -0.09, 0.008], mass: 0.1}
  - {pos: [0.03, 0.12, 0.02], vel: [0, 0, 0.3], mass: 0.5, radius: 0.03}
surfaces:
  - {faces: [[0, 1, 2], [3, 4, 5]], self_contact: {thickness: 0.01, stiffness: 100, friction: FRICTION}}
)";
std::string with_friction(const char* friction) {
  std::string text = two_triangles;
  return text.replace(text.find("FRICTION"), 8, friction);
}

struct Drawn {
  Meeting kind;
  Place e1, e2, r;
};

// Parts that meet, drawn until the window, the angle and the distance all vary.
std::vector<Drawn> drawn_pairs(std::size_t count) {
  std::mt19937_64 bits(1);
  const auto unit = [&] { return static_cast<Real>(bits() >> 11U) * 0x1p-53L; };
  const scene::SelfContact law{0.01, 100, 0};
  std::vector<Drawn> all;
  scene::Apart<Real> apart;
  while (all.size() < count) {
    Drawn one{all.size() % 2 == 0 ? Meeting::two_edges : Meeting::point_and_triangle, {}, {}, {}};
    one.e1 = {0.1L, 0.02L * unit(), 0.02L * unit()};
    one.e2 = {0.1L * unit(), 0.05L * unit(), 0.01L * unit()};
    for (std::size_t d = 0; d < 3; ++d) one.r[d] = (unit() - 0.4L) * (d == 2 ? 0.03L : 0.2L);
    if (meet(one.kind, law, 0, one.e1, one.e2, one.r, apart) && apart.distance > 1e-3L &&
        apart.energy > 1e-5L)
      all.push_back(one);
  }
  return all;
}

// In extended precision by differences of order 4 at d = 1e-6 m, a hundredth of a percent of the
// thickness: their truncation is below 1e-11 of the force at a millimetre, their rounding 1e-19 E /
// d.
TEST(Surface, ForcesAreTheDerivativesOfTheirPotential) {
  const scene::SelfContact law{0.01, 100, 0};
  std::size_t in_windows = 0;
  for (const Drawn& one : drawn_pairs(200)) {
    scene::Apart<Real> apart, moved;
    ASSERT_TRUE(meet(one.kind, law, 0, one.e1, one.e2, one.r, apart));
    in_windows += apart.u < 0.1L;
    Real scale = 0;
    for (const Place* force : {&apart.on_r, &apart.on_e1, &apart.on_e2})
      for (const Real f : *force) scale = std::max(scale, std::abs(f));
    for (std::size_t i = 0; i < 9; ++i) {
      const auto energy_at = [&](Real d) {
        Drawn other = one;
        (i < 3 ? other.r : i < 6 ? other.e1 : other.e2)[i % 3] += d;
        return meet(other.kind, law, 0, other.e1, other.e2, other.r, moved) ? moved.energy : 0;
      };
      const Real d = 1e-6L;
      const Real slope =
          (8 * (energy_at(d) - energy_at(-d)) - energy_at(2 * d) + energy_at(-2 * d)) / (12 * d);
      const Real force = (i < 3 ? apart.on_r : i < 6 ? apart.on_e1 : apart.on_e2)[i % 3];
      EXPECT_NEAR(static_cast<double>((force + slope) / scale), 0, 1e-9) << i;
    }
  }
  EXPECT_GT(in_windows, 20U);
}

// Beyond the thickness there is nothing, and just below it the force rises as the third power.
TEST(Surface, TheForceBeginsWithTwoContinuousDerivatives) {
  const scene::SelfContact law{0.01, 100, 0};
  const auto force = [&](Real d) { return -scene::repulsion(law, d).slope; };
  EXPECT_EQ(force(0.01), 0);
  EXPECT_EQ(force(0.011L), 0);
  const Real near = force(0.01L * (1 - 1e-4L)), nearer = force(0.01L * (1 - 5e-5L));
  EXPECT_NEAR(static_cast<double>(near / nearer), 8, 0.01);
  EXPECT_NEAR(static_cast<double>(force(0.005L)), 100 * 0.005, 1e-12) << "as a spring's";
  EXPECT_GT(force(1e-9L), 1e3);
}

TEST(Surface, MomentumAndAngularMomentumAreKept) {
  const SceneProblem problem(read(with_friction("0")));
  std::vector<double> rate(problem.size());
  const double* const q = problem.start().data();
  problem.acceleration(0, q, q + rate.size() / 2, rate.data() + rate.size() / 2);
  double largest = 0;
  for (const double a : rate) largest = std::max(largest, std::abs(a));
  EXPECT_GT(largest, 1) << "they meet";
  std::copy_n(q, rate.size() / 2, rate.data());
  for (const double p : problem.momentum(rate.data())) EXPECT_NEAR(p, 0, 1e-14 * largest);
  for (const double l : problem.angular_momentum(rate.data())) EXPECT_NEAR(l, 0, 1e-15 * largest);
  EXPECT_GT(problem.potential(q), 0);
}

// Compares with central differences, as scene_terms_test.cpp does; friction changes over
// friction_speed.
TEST(Surface, TheJacobianIsExact) {
  for (const char* const friction : {"0", "0.3"}) {
    const SceneProblem problem(read(with_friction(friction)));
    const std::size_t size = problem.size(), half = size / 2;
    std::vector<double> x(size), product(size), high(half), low(half);
    for (std::size_t i = 0; i < size; ++i) x[i] = std::sin(1.0 + 3.0 * static_cast<double>(i));
    problem.jacobian_times(0, problem.start().data(), x.data(), product.data());
    const double d = 1e-8;
    const auto at = [&](double sign, std::vector<double>& a) {
      std::vector<double> moved = problem.start();
      for (std::size_t i = 0; i < size; ++i) moved[i] += sign * d * x[i];
      problem.acceleration(0, moved.data(), moved.data() + half, a.data());
    };
    at(1, high), at(-1, low);
    double scale = 0;
    for (std::size_t i = half; i < size; ++i) scale = std::max(scale, std::abs(product[i]));
    EXPECT_GT(scale, 100);
    for (std::size_t i = 0; i < half; ++i)
      EXPECT_NEAR(product[half + i], (high[i] - low[i]) / (2 * d), 1e-6 * scale) << i;
  }
}

TEST(Surface, IsATermOnlyOfASceneThatHasSurfaces) {
  EXPECT_TRUE(SceneProblem(read(tests::with_particles(""))).structure().terms.empty());
  const SceneProblem present(read(with_friction("0")));
  const auto& terms = present.structure().terms;
  EXPECT_TRUE(std::ranges::any_of(
      terms, [](const scene::TermInfo& term) { return term.name == "self_contact"; }));
}

// Pairs are computed in vector lanes, each rounded as it is alone, and added in their order.
TEST(Surface, ForcesAreThoseOfPairAfterPair) {
  for (const char* const friction : {"0", "0.3"}) {
    const Scene scene = read(with_friction(friction));
    const SceneProblem problem(scene);
    const scene::Surfaces surfaces(scene);
    const double *const q = problem.start().data(), *const v = q + 3 * scene.size();
    std::vector<double> a(3 * scene.size()), force(a.size());
    problem.acceleration(0, q, v, a.data());
    std::vector<scene::SurfacePair> pairs;
    surfaces.find_near(q, 0, pairs);
    std::size_t acting = 0;
    for (const scene::SurfacePair& pair : pairs) {
      const scene::SelfContact& law = surfaces.law(pair.law);
      scene::Vec<double> e1, e2, r;
      scene::Apart<double> apart;
      scene::differences_of(pair, q, e1, e2, r);
      if (!scene::meet(pair, law, e1, e2, r, apart)) continue;
      ++acting;
      scene::differences_of(pair, v, e1, e2, r);
      if (law.friction > 0) scene::add_friction(law, scene::friction_speed, e1, e2, r, apart);
      const scene::Shares share = scene::shares_of(pair.kind);
      for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t d = 0; d < 3; ++d)
          force[3 * pair.x[k] + d] += share.r[k] * apart.on_r[d] + share.e1[k] * apart.on_e1[d] +
                                      share.e2[k] * apart.on_e2[d];
    }
    EXPECT_GT(acting, 3U);
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_DOUBLE_EQ(a[i], force[i] / scene.particles[i / 3].mass) << i;
  }
}

TEST(Surface, WhatPassesThroughIsFound) {
  Scene scene = read(with_friction("0"));
  const scene::Surfaces surfaces(scene);
  const std::vector<double> q = scene::start_of(scene);
  std::vector<double> to = q;
  EXPECT_TRUE(scene::passed_between(surfaces, q.data(), to.data()).empty());
  const scene::Touching touching = scene::touching_at(surfaces, q.data());
  EXPECT_GT(touching.pairs, 1U);
  EXPECT_GT(touching.deepest, 0.003);
  EXPECT_LT(touching.deepest, 0.01);
  // The second triangle falls through the first one: its corner through the triangle, and edges.
  for (const std::size_t i : {3U, 4U, 5U}) to[3 * i + 2] -= 0.05;
  const auto passed = scene::passed_between(surfaces, q.data(), to.data());
  const auto count = [&](scene::SurfacePair::Kind kind) {
    return std::count_if(passed.begin(), passed.end(),
                         [&](const auto& p) { return p.kind == kind; });
  };
  EXPECT_EQ(count(scene::SurfacePair::Kind::triangle), 1);
  EXPECT_GE(count(scene::SurfacePair::Kind::edges), 1);
  // To the side, it passes nothing.
  to = q;
  for (const std::size_t i : {3U, 4U, 5U}) to[3 * i] += 0.5;
  EXPECT_TRUE(scene::passed_between(surfaces, q.data(), to.data()).empty());
  // A corner that flies through the ball within a step.
  to = q;
  to[6] += 0.06, to[7] += 0.04, to[8] += 0.04;
  const auto into = scene::passed_between(surfaces, q.data(), to.data());
  ASSERT_FALSE(into.empty());
  EXPECT_EQ(into.back().kind, scene::SurfacePair::Kind::corner);
  EXPECT_EQ(into.back().x[0], 2U);
}

}  // namespace
}  // namespace odeum::surface_test
