// SPDX-License-Identifier: BSD-3-Clause
// Bullet's own collisions of a surface with itself.
#include <gtest/gtest.h>

#include "adapters/bullet_stage.hpp"

namespace odeum::bullet_tests {
namespace {

// A corner of a strip falls on the triangle beside its own, 30 mm below: Bullet's own collisions
// keep it above, where without surfaces it falls through.
TEST(Bullet, SelfCollisionKeepsASurfaceAboveItself) {
  scene::Scene scene;
  scene.gravity = {0, 0, -9.81};
  for (const scene::Vec3& x : {scene::Vec3{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})
    scene.particles.push_back({.position = x, .fixed = true});
  scene.particles.push_back({.position = {0.2, 0.2, 0.03}, .mass = 0.1});
  const scene::Surface law{{0.01, 100, 0}, {{0, 1, 2}, {1, 2, 3}}};
  const auto height_after = [&](const char* method) {
    const Stage made =
        stage<24>(scene, std::array<double, 24>{0, 0, 0, 1, 0, 0, 0, 1, 0, 0.2, 0.2, 0.03});
    EXPECT_EQ(made[method].unfit, "");
    const Outcome outcome = made[method].solve(steps(500, {0.5}));
    EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
    return outcome.states.at(11);
  };
  EXPECT_LT(height_after("deformable_explicit"), -1);
  scene.surfaces = {law};
  EXPECT_GT(height_after("deformable_self_collision"), 0);
  EXPECT_LT(height_after("deformable_self_collision"), 0.03);
  // A second piece, a ball, and a second law: each has its sentence.
  const auto objection = [&](const scene::Scene& other) {
    return stage<24>(other, {})["deformable_self_collision"].unfit;
  };
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
  const Stage two = stage<42>(other, {});
  EXPECT_NE(two["deformable_self_collision"].unfit.find("one piece"), std::string::npos);
}

}  // namespace
}  // namespace odeum::bullet_tests
