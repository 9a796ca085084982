// SPDX-License-Identifier: BSD-3-Clause
// Stiffness and damping of springs in each solver of the Bullet adapter, and the effect of its
// iterations.
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/studies/material/material.hpp"

namespace odeum::study::bullet_material_test {
namespace {

MaterialRow response(const Specimen& specimen, const char* id, double step,
                     const Iterations& iterations = {}) {
  const SceneStage stage(specimen.scene());
  return measure_response(specimen, stage, find_solver(stage.entrants, id), step, iterations);
}

Specimen undamped(Specimen specimen) {
  specimen.damping = 0;
  return specimen;
}

// A strain of 1e-4 changes the law of a link by half of it (its law is not linear), and the swing,
// a tenth of the strain, far less.
constexpr double strain = 1e-4;

TEST(BulletMaterial, MatchedLinksAreBackwardEulerAtSmallStrain) {
  for (const double h : {1.0 / 120, 1.0 / 480}) {
    const MaterialRow euler = response(undamped(one_mass()), "odeum/implicit_euler", h);
    for (const std::uint64_t sweeps : {0, 1, 8}) {
      const MaterialRow links =
          response(undamped(one_mass()), "bullet/soft_body_links", h, {.sweeps = sweeps});
      EXPECT_NEAR(links.dynamic_stiffness_ratio / euler.dynamic_stiffness_ratio, 1, 10 * strain)
          << h << " " << sweeps;
      EXPECT_NEAR(links.added_damping_ratio, euler.added_damping_ratio, 10 * strain);
      EXPECT_NEAR(links.static_stiffness_ratio, 1, 10 * strain);
    }
  }
}

TEST(BulletMaterial, ImplicitIsBackwardEulerAndForcesAreSymplecticEuler) {
  for (const Specimen& specimen : {one_mass(), hanging_chain()}) {
    const double h = 1.0 / 240;
    const MaterialRow implicit = response(specimen, "bullet/deformable_implicit", h),
                      euler = response(specimen, "odeum/implicit_euler", h),
                      forces = response(specimen, "bullet/soft_body_force", h),
                      symplectic = response(specimen, "odeum/symplectic_euler", h);
    // Conjugate gradients stop at 1e-8 of a residual, Newton's method at 1e-10 of 1 m; the step of
    // forces is rounded to 6e-8 of itself.
    EXPECT_NEAR(implicit.dynamic_stiffness_ratio, euler.dynamic_stiffness_ratio, 1e-4);
    EXPECT_NEAR(implicit.damping / euler.damping, 1, 1e-4);
    EXPECT_NEAR(forces.dynamic_stiffness_ratio, symplectic.dynamic_stiffness_ratio, 1e-5);
    EXPECT_NEAR(forces.damping / symplectic.damping, 1, 1e-4);
  }
}

// With kLST = 1 the stiffness follows from the number of sweeps and the step, not from the
// material.
TEST(BulletMaterial, StockLinksAreAsStiffAsTheyAreSwept) {
  const Specimen chain = hanging_chain();
  const auto stiffness = [&](double h, std::uint64_t sweeps) {
    return response(chain, "bullet/soft_body_links_stock", h, {.sweeps = sweeps})
        .static_stiffness_ratio;
  };
  const double once = stiffness(1.0 / 240, 1);
  // A sweep propagates a correction by one link, so that a second one does not quite double its
  // effect.
  EXPECT_NEAR(stiffness(1.0 / 240, 2) / once, 2, 0.1);
  EXPECT_NEAR(stiffness(1.0 / 480, 1) / once, 4, 0.1);
  EXPECT_EQ(stiffness(1.0 / 240, 0), once) << "one sweep is Bullet's default";
  Specimen softer = chain;
  softer.stiffness /= 2;
  // Half of the nominal stiffness, and the same sag: twice the ratio.
  EXPECT_NEAR(
      response(softer, "bullet/soft_body_links_stock", 1.0 / 240).static_stiffness_ratio / once, 2,
      0.01);
}

TEST(BulletMaterial, MatchedLinksOfAChainAreSoftWhateverTheSweeps) {
  const double h = 1.0 / 60;
  for (const std::uint64_t sweeps : {1, 32}) {
    const MaterialRow row =
        response(hanging_chain(), "bullet/soft_body_links", h, {.sweeps = sweeps});
    EXPECT_GT(row.dynamic_stiffness_ratio, 0.2);
    EXPECT_LT(row.dynamic_stiffness_ratio, 0.5) << "the match is of one link alone";
  }
}

TEST(BulletMaterial, FewConjugateGradientsAreSoft) {
  const double h = 1.0 / 30;
  const auto run = [&](const Iterations& iterations) {
    return response(hanging_chain(), "bullet/deformable_implicit", h, iterations)
        .dynamic_stiffness_ratio;
  };
  const double whole = run({});
  EXPECT_LT(run({.sweeps = 1}), 0.1 * whole);
  EXPECT_NEAR(run({.sweeps = 16}), whole, 1e-6) << "as many as there are masses are enough";
  EXPECT_NEAR(run({.newton = 4}), whole, 1e-6) << "hanging straight it is linear";
}

TEST(BulletMaterial, NewtonIterationsEndAtBackwardEulerOfACloth) {
  SceneStage stage([] {
    scene::Scene scene;  // strongly bent and stretched: one Newton iteration is not enough
    scene.gravity = {0, -9.8, 0};
    scene.particles = {{.position = {0, 0, 0}, .mass = 1, .fixed = true},
                       {.position = {1, 0, 0.5}, .velocity = {0, 4, 2}, .mass = 2},
                       {.position = {2, 0.5, 0}, .velocity = {3, 0, 0}, .mass = 0.5}};
    scene.springs = {{.a = 0, .b = 1, .stiffness = 30, .damping = 0.4, .rest_length = 1},
                     {.a = 2, .b = 1, .stiffness = 30, .damping = 0.4, .rest_length = 0.8}};
    return scene;
  }());
  Request request;
  request.steps = 10;
  request.stops = {1};
  const auto distance = [&](double newton) {
    request.options = {{"newton", newton}};
    const Outcome engine = find_solver(stage.entrants, "bullet/deformable_implicit").solve(request),
                  own = find_solver(stage.entrants, "odeum/implicit_euler").solve(request);
    EXPECT_EQ(engine.status, Status::ok) << engine.detail;
    EXPECT_EQ(own.status, Status::ok) << own.detail;
    return rms_distance(engine.states, own.states, 3);
  };
  EXPECT_GT(distance(1), 1e-4);
  EXPECT_LT(distance(8), 1e-6);  // conjugate gradients stop at 1e-8 of a residual, ten steps
  EXPECT_EQ(distance(0), distance(1)) << "one is Bullet's default";
}

}  // namespace
}  // namespace odeum::study::bullet_material_test
