// SPDX-License-Identifier: BSD-3-Clause
// Runs of scenes whose surfaces meet: orders, energy, and what passed through.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "odeum/cases/scene_case.hpp"
#include "odeum/scene/read/reader.hpp"
#include "odeum/scene/run/run.hpp"
#include "odeum/trajectories/scene_verdict.hpp"

namespace odeum::surface_run_test {
namespace {

using scene::RunResult;
using scene::Scene;

// A free triangle of springs bounces from two fixed ones, over the edge between them.
Scene bouncing() {
  return scene::read_scene("s.yaml", R"(
gravity: 0
duration: 1
solver: {type: rk4, timestep: 0.001}
particles:
  - {pos: [0, 0, 0], mass: 1, fixed: true}
  - {pos: [1, 0, 0], mass: 1, fixed: true}
  - {pos: [0, 1, 0], mass: 1, fixed: true}
  - {pos: [1, 1, 0.1], mass: 1, fixed: true}
  - {pos: [0.3, 0.35, 0.35], vel: [0.5, 0.3, -0.6], mass: 0.01}
  - {pos: [0.5, 0.2, 0.4], vel: [0.5, 0.3, -0.6], mass: 0.01}
  - {pos: [0.3, 0.6, 0.45], vel: [0.5, 0.3, -0.6], mass: 0.01}
springs:
  - {particle_ids: [4, 5], stiffness: 10}
  - {particle_ids: [5, 6], stiffness: 10}
  - {particle_ids: [6, 4], stiffness: 10}
surfaces:
  - {faces: [[0, 1, 2], [1, 3, 2]], self_contact: {thickness: 0.1, stiffness: 3}}
  - {faces: [[4, 5, 6]], self_contact: {thickness: 0.1, stiffness: 3}}
)")
      .scene;
}

RunResult run(const Scene& scene, std::uint64_t steps, const std::string& method) {
  scene::RunSetting setting;
  setting.steps = steps;
  setting.until = *scene.duration;
  setting.frame_interval = setting.until / 50;
  return scene::run_scene(
      scene, setting,
      [&](const std::shared_ptr<const scene::SceneProblem>& problem, const Request& request) {
        return cases::enroll_scene(problem).find("odeum/" + method)->solve(request);
      });
}

double total(const scene::Frame& frame) { return frame.kinetic + frame.potential; }

// Three derivatives of the potential are continuous, so that a step in which a contact begins, or
// a corner crosses an edge, errs by O(h^4): that is the order which any method keeps at most. Over
// five halvings the factors of those steps, which depend on where in a step that is, average out.
TEST(SurfaceRun, RungeAndKuttasMethodKeepsOrderFour) {
  const Scene scene = bouncing();
  const RunResult exact = run(scene, 51200, "rk4");
  ASSERT_EQ(exact.status, Status::ok);
  const auto error = [&](std::uint64_t steps) {
    const RunResult result = run(scene, steps, "rk4");
    double largest = 0;
    for (std::size_t i = 0; i < exact.frames.back().y.size(); ++i)
      largest = std::max(largest, std::abs(result.frames.back().y[i] - exact.frames.back().y[i]));
    return largest;
  };
  EXPECT_GT(exact.contacts.deepest.deepest, 0.03);
  const double coarse = error(200), fine = error(6400);
  EXPECT_GT(coarse, 1e-8);
  EXPECT_NEAR(std::log2(coarse / fine) / 5, 4, 0.25) << coarse << " " << fine;
}

// Stormer and Verlet's error of the energy is periodic, of order 2, and none is lost by a bounce.
TEST(SurfaceRun, ASymplecticMethodKeepsTheEnergy) {
  const Scene scene = bouncing();
  double before = 0;
  for (const std::uint64_t steps : {1000U, 2000U}) {
    const RunResult result = run(scene, steps, "velocity_verlet");
    double worst = 0;
    for (const scene::Frame& frame : result.frames)
      worst = std::max(worst, std::abs(total(frame) / total(result.frames.front()) - 1));
    EXPECT_LT(worst, 1e-3);
    EXPECT_NEAR(total(result.frames.back()) / total(result.frames.front()), 1, 1e-3);
    EXPECT_EQ(result.contacts.passed, 0U);
    if (before > 0) {
      EXPECT_NEAR(before / worst, 4, 1);
    }
    before = worst;
  }
}

TEST(SurfaceRun, WhatPassesThroughIsSaid) {
  Scene scene = bouncing();
  for (std::size_t i = 4; i < 7; ++i) scene.particles[i].velocity = {0, 0, -40};
  const RunResult result = run(scene, 20, "rk4");
  ASSERT_EQ(result.status, Status::ok);
  EXPECT_GT(result.contacts.passed, 0U);
  const std::string text = trajectories::text_of_contacts(result.contacts);
  EXPECT_EQ(trajectories::scene_answer(result, Mode::fixed, "", nullptr).answer,
            judge::Answer::wrong);
  EXPECT_NE(text.find("passed through each other, the first in the 0.05 s before t = 0.05"),
            std::string::npos)
      << text;
  // The same with steps that are fine enough: the potential keeps it on its side.
  scene.particles[4].velocity = scene.particles[5].velocity =
      scene.particles[6].velocity = {0, 0, -1};
  EXPECT_EQ(run(scene, 4000, "rk4").contacts.passed, 0U);
}

}  // namespace
}  // namespace odeum::surface_run_test
