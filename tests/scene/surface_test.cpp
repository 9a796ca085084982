// SPDX-License-Identifier: BSD-3-Clause
// Surfaces that meet: the potential between two parts of them, what is near, what passes through.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/read/reader.hpp"
#include "odeum/scene/surface/passing.hpp"
#include "support/scene_texts.hpp"

namespace odeum {
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

// By central differences, as in scene_terms_test.cpp; friction changes over friction_speed.
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

TEST(Surface, AnAbsentTermCostsNothing) {
  SceneProblem problem(read(tests::with_particles("")));
  scene::Tally tally;
  problem.count_into(&tally);
  std::vector<double> a(problem.size() / 2);
  problem.acceleration(0, problem.start().data(), problem.start().data() + a.size(), a.data());
  EXPECT_TRUE(tally.entries.empty());
  SceneProblem present(read(with_friction("0")));
  present.count_into(&tally);
  a.resize(present.size() / 2);
  present.acceleration(0, present.start().data(), present.start().data() + a.size(), a.data());
  EXPECT_EQ(tally.entries.at("self_contact").evaluations, 1U);
}

/// A sheet of n x n in waves, as the surface of a scene.
Scene wavy(std::size_t n, double height) {
  Scene scene = read(fmt::format(
      "duration: 1\nsolver: {{type: rk4, timestep: 0.001}}\ncloth: [{{rows: {0}, columns: {0}, "
      "row_edge: [1, 0, 0], column_edge: [0, 1, 0], mass: 1, structural: {{stiffness: 10}}, "
      "self_contact: {{thickness: 0.06, stiffness: 10}}}}]\n",
      n));
  for (scene::Particle& particle : scene.particles) {
    const double x = particle.position[0];
    particle.position[0] = 0.1 * x + 0.15 * std::sin(14 * x + particle.position[1]);
    particle.position[2] = height * x;
  }
  return scene;
}

// All pairs of parts are tried, in place of those in neighbouring cells.
TEST(Surface, WhatIsNearIsFound) {
  const Scene scene = wavy(14, 0.4);
  const scene::Surfaces surfaces(scene);
  const std::vector<double> q = scene::start_of(scene);
  const double margin = 0.02;
  std::vector<scene::SurfacePair> pairs;
  surfaces.find_near(q.data(), margin, pairs);
  std::set<std::pair<scene::SurfacePair::Kind, std::array<std::uint32_t, 4>>> found;
  for (const scene::SurfacePair& pair : pairs) {
    EXPECT_TRUE(found.insert({pair.kind, pair.x}).second) << "found twice";
    EXPECT_LE(pair.slack, margin);
  }
  std::size_t acting = 0, tried = 0;
  const auto& faces = scene.surfaces[0].faces;
  for (const auto& face : faces)
    for (std::uint32_t p = 0; p < scene.size(); ++p) {
      if (p == face[0] || p == face[1] || p == face[2]) continue;
      scene::SurfacePair pair{
          {std::uint32_t(face[0]), std::uint32_t(face[1]), p, std::uint32_t(face[2])},
          scene::SurfacePair::Kind::triangle};
      scene::Vec<double> e1, e2, r;
      scene::Apart<double> apart;
      scene::differences_of(pair, q.data(), e1, e2, r);
      ++tried;
      if (!scene::meet(pair, surfaces.law(0), e1, e2, r, apart)) continue;
      ++acting;
      EXPECT_TRUE(found.contains({pair.kind, pair.x})) << apart.distance;
    }
  EXPECT_GT(acting, 50U);
  EXPECT_LT(pairs.size(), tried / 5);
}

// Pairs are kept while they may still act: what is computed depends on the state alone.
TEST(Surface, ForcesDoNotDependOnWhatWasComputedBefore) {
  const Scene scene = wavy(14, 0.4);
  const SceneProblem problem(scene), other(scene);
  std::vector<double> y = problem.start(), a(y.size() / 2), b(a.size());
  const double* const v = y.data() + a.size();
  problem.acceleration(0, y.data(), v, a.data());
  std::size_t changed = 0;
  for (int k = 0; k < 30; ++k) {
    for (std::size_t i = 0; i < a.size(); ++i) y[i] += 0.002 * std::sin(0.3 * k + 5.0 * double(i));
    problem.acceleration(0, y.data(), v, a.data());
    const SceneProblem fresh(scene);
    fresh.acceleration(0, y.data(), v, b.data());
    ASSERT_EQ(a, b) << k;
    changed += a[0] != 0;
  }
  EXPECT_GT(changed, 0U);
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
}  // namespace odeum
