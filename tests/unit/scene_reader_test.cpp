// SPDX-License-Identifier: BSD-3-Clause
// The scene reader on valid input.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/scene/read/reader.hpp"
#include "support/scene_stage.hpp"
#include "support/scene_texts.hpp"

namespace odeum {
namespace {

using scene::read_scene;
using tests::with_particles;

TEST(SceneReader, TakesTheTeachingFormat) {
  const auto read = read_scene("s.yaml", R"(
name: pair
gravity: 1.5
duration: 2
solver: {type: midpoint, timestep: 0.01}
particles:
  - pos: [0, 0, 2]
    fixed: true
  - pos: [3, 4, 2]
    vel: [1, -2, 3e-1]
    mass: 0.5
    radius: 0.1
springs:
  - particle_ids: [0, 1]
    stiffness: 20.0
    damping: 0.5
)");
  const scene::Scene& d = read.scene;
  EXPECT_TRUE(read.warnings.empty());
  EXPECT_EQ(d.name, "pair");
  EXPECT_EQ(d.gravity, (scene::Vec3{0, 0, -1.5}));
  EXPECT_EQ(d.duration, 2);
  EXPECT_EQ(d.solver->type, "midpoint");
  EXPECT_EQ(d.solver->step, 0.01);
  ASSERT_EQ(d.particles.size(), 2U);
  EXPECT_TRUE(d.particles[0].fixed);
  EXPECT_EQ(d.particles[1].velocity, (scene::Vec3{1, -2, 0.3}));
  EXPECT_EQ(d.particles[1].radius, 0.1);
  ASSERT_EQ(d.springs.size(), 1U);
  EXPECT_EQ(d.springs[0].rest_length, 5) << "the distance at the start";
  EXPECT_TRUE(d.springs[0].axial);
}

TEST(SceneReader, SpreadsAClothOut) {
  const auto d = read_scene("s.yaml", with_particles(R"(
cloth:
  rows: 3
  columns: 4
  origin: [0, 0, 1]
  row_edge: [2, 0, 0]
  column_edge: [0, 3, 0]
  mass: 6
  structural: {stiffness: 10, damping: 0.1}
  shear: {stiffness: 5}
  bend: {stiffness: 2}
  damping_model: full
  fixed: [{column: 3}, {row: 0, column: 0}]
  velocity: [{rows: [1, 2], columns: [0, 3], value: [0, 0, 1]}]
)"))
                     .scene;
  ASSERT_EQ(d.particles.size(), 2U + 12U);
  EXPECT_EQ(d.cloths.front().first, 2U);
  EXPECT_EQ(d.particles[2 + 1 * 4 + 2].position, (scene::Vec3{1, 2, 1}));
  EXPECT_EQ(d.particles[2 + 5].mass, 0.5);
  int fixed = 0;
  for (const auto& particle : d.particles) fixed += particle.fixed;
  EXPECT_EQ(fixed, 4);
  // structural 3*3 + 2*4 = 17; shear 2*2*3 = 12; bend 3*2 + 1*4 + 2*1*2 = 14
  EXPECT_EQ(d.springs.size(), 17U + 12U + 14U);
  EXPECT_EQ(d.particles[2 + 4].velocity, (scene::Vec3{0, 0, 1}));
  EXPECT_EQ(d.particles[2 + 7].velocity, scene::Vec3{}) << "fixed particles do not move";
}

TEST(SceneReader, SharesAnchors) {
  const auto d = read_scene("s.yaml", std::string(tests::two_particles) + R"(springs:
  - &like {particle_ids: [0, 1], stiffness: 3}
forces:
  - drag: &c {coefficient: 2}
  - quadratic_drag: *c
)")
                     .scene;
  EXPECT_EQ(d.forces.size(), 2U);
}

TEST(SceneReader, ReadsEveryBuiltInScene) {
  EXPECT_GE(cases::all_scenes().size(), 12U);
  for (const cases::SceneText& scene : cases::all_scenes()) {
    const auto read = read_scene(std::string(scene.name), std::string(scene.text));
    EXPECT_TRUE(read.warnings.empty()) << scene.name;
    EXPECT_TRUE(scene.text.find("\n# See:") != std::string_view::npos) << scene.name;
  }
}

}  // namespace
}  // namespace odeum
