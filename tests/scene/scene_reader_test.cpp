// SPDX-License-Identifier: BSD-3-Clause
// The scene reader on valid input.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/scene_case.hpp"
#include "odeum/scene/read/reader.hpp"
#include "support/scene_texts.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::scene_reader_test {
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
  EXPECT_FALSE(d.solver->tolerance);
  ASSERT_EQ(d.particles.size(), 2U);
  EXPECT_TRUE(d.particles[0].fixed);
  EXPECT_EQ(d.particles[1].velocity, (scene::Vec3{1, -2, 0.3}));
  EXPECT_EQ(d.particles[1].radius, 0.1);
  ASSERT_EQ(d.springs.size(), 1U);
  EXPECT_EQ(d.springs[0].rest_length, 5) << "the distance at the start";
  EXPECT_TRUE(d.springs[0].axial);
}

TEST(SceneReader, TakesARelativeAndAnAbsoluteTolerance) {
  const auto solver = [](const std::string& tolerance) {
    return read_scene("s.yaml", "duration: 1\nsolver: {type: rk4, tolerance: " + tolerance +
                                    "}\nparticles: [{pos: [0, 0, 0], mass: 1}]\n")
        .scene.solver;
  };
  EXPECT_EQ(solver("1e-6")->tolerance->relative, 1e-6);
  EXPECT_EQ(solver("1e-6")->tolerance->absolute(0), 1e-6);
  EXPECT_EQ(solver("{relative: 1e-6, absolute: 1e-9}")->tolerance->relative, 1e-6);
  EXPECT_EQ(solver("{relative: 1e-6, absolute: 1e-9}")->tolerance->absolute(0), 1e-9);
  EXPECT_THROW(solver("{relative: 1e-6}"), InputError);
  EXPECT_THROW(solver("{relative: 1e-6, absolute: -1}"), InputError);
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

// A file as a course hands it out: no duration, a plot, merge keys, keys that only a viewer needs.
constexpr const char* course_file = R"(
solver:
  type: explicit_euler   # symplectic_euler
  timestep: 0.0005
camera: {position: [0, -3, 1]}
plot:
  particle_id: 1
  dof: 2
  y_range: [0.7, 1.2]
particles:
  - &ball
    pos: [0, 0, 2.]
    vel: &rest [0, 0, 0]
    fixed: true
    mass: .1
  - <<: *ball
    pos: [0, 0, 1]
    fixed: false
    radius: 0.2
    color: [1, 0, 0]
  - {<<: [{mass: 3}, *ball], pos: [0, 1, 1], fixed: false}
springs:
  - particle_ids: [0, 1]
    stiffness: 20.
)";

TEST(SceneReader, TakesCourseFilesUnchanged) {
  const auto read = read_scene("s.yaml", course_file);
  const scene::Scene& d = read.scene;
  EXPECT_FALSE(read.duration_given);
  EXPECT_EQ(d.duration, 10);
  ASSERT_TRUE(d.plot);
  EXPECT_EQ(d.plot->particle, 1U);
  EXPECT_EQ(d.plot->coordinate, 2U);
  EXPECT_EQ(d.plot->y_range, (std::array<double, 2>{0.7, 1.2}));
  ASSERT_EQ(d.particles.size(), 3U);
  EXPECT_EQ(d.particles[1].position, (scene::Vec3{0, 0, 1})) << "an own key comes first";
  EXPECT_FALSE(d.particles[1].fixed);
  EXPECT_EQ(d.particles[1].mass, 0.1) << "merged";
  EXPECT_EQ(d.particles[2].mass, 3) << "the first of several mappings comes first";
  ASSERT_EQ(read.warnings.size(), 2U);
  EXPECT_EQ(read.warnings[0], "s.yaml:5:1: camera: only a viewer needs it; it is not used");
  EXPECT_EQ(read.warnings[1],
            "s.yaml:20:5: particles[1].color: only a viewer needs it; it is not used");
  EXPECT_TRUE(read_scene("s.yaml", tests::two_particles).duration_given);
}

TEST(SceneReader, TakesTheLookOfEmittedParticles) {
  const tests::TemporaryFolder folder;
  const std::string png = "\x89PNG\r\n\x1a\n and the rest";
  tests::write_text(folder.path() / "puff.png", png);
  tests::write_text(folder.path() / "s.yaml",
                    "solver: {type: rk4, timestep: 0.1}\nemitters:\n- {position: [0, 0, 0], "
                    "velocity: [0, 0, 1], rate: 10, mass: 1, look: {colour: [[1, 0.5, 0], [1, 0, "
                    "0]], size: [0.1, 0.2], opacity: [1, 0], blend: add, texture: puff.png}}\n");
  const auto d = scene::read_scene_file((folder.path() / "s.yaml").string()).scene;
  ASSERT_EQ(d.emitters.size(), 1U);
  ASSERT_TRUE(d.emitters[0].look);
  const scene::Look& look = *d.emitters[0].look;
  EXPECT_EQ(look.colour[0], (scene::Vec3{1, 0.5, 0}));
  EXPECT_EQ(look.size, (std::array<double, 2>{0.1, 0.2}));
  EXPECT_TRUE(look.additive);
  EXPECT_EQ(look.texture, png) << "beside the scene's file";
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
}  // namespace odeum::scene_reader_test
