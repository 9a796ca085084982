// SPDX-License-Identifier: BSD-3-Clause
// Bullet's own collisions of a surface with itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "adapters/bullet_stage.hpp"
#include "odeum/cases/scene_case.hpp"
#include "odeum/scene/read/reader.hpp"

namespace odeum::bullet_tests::bullet_self_collision_test {
namespace {

// On the cloth whose halves meet at 0.44 s: up to then it moves as without surfaces, and not after.
TEST(BulletSelfCollision, ActsWhereSurfacesMeet) {
  scene::Scene scene =
      scene::read_scene_file(ODEUM_SOURCE_DIR "/cases/scenes/cloth_folding.yaml").scene;
  const auto run = [&](const char* solver) {
    const auto problem = std::make_shared<const scene::SceneProblem>(scene);
    const Outcome outcome =
        cases::enroll_scene(problem).find(solver)->solve(steps(1000, {0.3, 0.5}));
    EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
    return outcome.states;
  };
  const std::vector<double> own = run("bullet/deformable_self_collision");
  scene.surfaces.clear();
  const std::vector<double> apart = run("bullet/deformable_explicit");
  ASSERT_EQ(own.size(), apart.size());
  double before = 0, after = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    double& largest = i < own.size() / 2 ? before : after;
    largest = std::max(largest, std::abs(own[i] - apart[i]));
  }
  EXPECT_LT(before, 1e-9);
  EXPECT_GT(after, 0.01);
}

TEST(BulletSelfCollision, SaysWhatDoesNotFit) {
  scene::Scene scene;
  for (const scene::Vec3& x : {scene::Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}})
    scene.particles.push_back({.position = x, .mass = 1});
  for (std::size_t i = 0; i < 3; ++i)
    scene.springs.push_back({.a = i, .b = i + 1, .stiffness = 1, .rest_length = 1});
  const scene::Surface law{{0.01, 100, 0}, {{0, 1, 2}, {1, 2, 3}}};
  scene.surfaces = {law};
  // A second piece, a ball, and a second law: each has its sentence.
  const auto objection = [&](const scene::Scene& other) {
    return stage<24>(other, {})["deformable_self_collision"].unfit;
  };
  EXPECT_EQ(objection(scene), "");
  scene::Scene other = scene;
  other.surfaces.push_back(law);
  other.surfaces[1].thickness = 0.02;
  EXPECT_NE(objection(other).find("one thickness"), std::string::npos);
  other = scene;
  other.surfaces[0].faces = {{0, 1, 2}};
  other.particles[3].radius = 0.01;
  EXPECT_NE(objection(other).find("none is a ball"), std::string::npos);
  for (int i = 0; i < 3; ++i)
    other.particles.push_back({.position = {0.1 * i, 0.01 * i * i, 1}, .mass = 1});
  other.particles[3].radius = 0;
  other.surfaces[0].faces = {{0, 1, 2}, {4, 5, 6}};
  for (std::size_t i = 3; i < 6; ++i)
    other.springs.push_back({.a = i, .b = i + 1, .stiffness = 1, .rest_length = 1});
  const Stage two = stage<42>(other, {});
  EXPECT_NE(two["deformable_self_collision"].unfit.find("one piece"), std::string::npos);
  scene.springs.pop_back();
  EXPECT_NE(objection(scene).find("one piece"), std::string::npos) << "a node without a link";
}

}  // namespace
}  // namespace odeum::bullet_tests::bullet_self_collision_test
