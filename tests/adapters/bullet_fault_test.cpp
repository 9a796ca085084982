// SPDX-License-Identifier: BSD-3-Clause
// Refusals and failures of the Bullet adapter: scenes, requests and runs that it cannot represent.
#include <gtest/gtest.h>

#include <thread>

#include "adapters/bullet_stage.hpp"

namespace odeum::bullet_tests::bullet_fault_test {
namespace {

bool needs_contacts(const Entrant& entrant) {
  return entrant.info.method == "soft_body_collision" ||
         entrant.info.method == "deformable_self_collision";
}

TEST(BulletFault, RefusesInASentence) {
  Request request = steps(10, {1});
  request.mode = Mode::adaptive;
  request.tolerance = 1e-6;
  const Stage stage = oscillator();
  for (const Entrant& entrant : stage.entrants) {
    if (needs_contacts(entrant)) continue;
    EXPECT_EQ(entrant.unfit, "") << entrant.info.id();
    EXPECT_EQ(entrant.solve(request).status, Status::refused) << entrant.info.id();
    EXPECT_NE(entrant.solve(request).detail, "");
    EXPECT_EQ(entrant.solve(steps(10, {0.33, 1})).status, Status::refused) << "off the grid";
    EXPECT_EQ(entrant.solve(steps(0, {1})).status, Status::refused);
  }
}

TEST(BulletFault, SaysWhatDoesNotFit) {
  Contest<Unseen<2>> bare;
  bare.problem = std::make_shared<const Unseen<2>>();
  bare.y0 = std::make_shared<const std::vector<double>>(2);
  const std::vector<Entrant> entrants =
      tests::enrolled_on(erase(bare), adapters::bullet::add_solvers);
  ASSERT_EQ(entrants.size(), 7u);
  for (const Entrant& entrant : entrants) EXPECT_NE(entrant.unfit, "") << entrant.info.id();

  const Stage rotation = medium({-0.5, 2});
  scene::Scene slack = *oscillator().scene;
  slack.springs[0].tension_only = true;
  const Stage tension_only = stage<2>(slack, {1, 0});
  for (const Stage* only_forces : {&rotation, &tension_only})
    for (const Entrant& entrant : only_forces->entrants)
      EXPECT_EQ(entrant.unfit.empty(), entrant.info.method == "soft_body_force")
          << entrant.info.id();
}

TEST(BulletFault, ReadsTheSceneAnewAtEachSolve) {
  const Stage stage = medium(-1);
  const Entrant& entrant = stage["deformable_explicit"];
  stage.scene->velocity_matrix = {-2, 0, 0, 0, -2};
  EXPECT_NEAR(entrant.solve(steps(1, {1})).states[0], 1.0 / 3, 1e-15);  // 1/(1 + 2h), h = 1
  stage.scene->velocity_matrix = {-2, -1, 0, 1, -2};
  EXPECT_EQ(entrant.solve(steps(1, {1})).status, Status::refused) << "it turns now";
  stage.scene->velocity_matrix = {2, 0, 0, 0, 2};
  EXPECT_EQ(entrant.solve(steps(1, {1})).status, Status::refused) << "it drives now";
}

TEST(BulletFault, NumbersThatAreNotFiniteAreSeen) {
  const Stage poisoned = oscillator(1);
  for (const Entrant& entrant : poisoned.entrants) {
    if (needs_contacts(entrant)) continue;
    for (double* number :
         {&poisoned.scene->springs[0].damping, &poisoned.scene->springs[0].stiffness,
          &poisoned.scene->gravity[2], &poisoned.scene->particles[1].velocity[1]}) {
      const double sound = *number;
      *number = std::nan("");
      EXPECT_EQ(entrant.solve(steps(10, {1})).status, Status::non_finite) << entrant.info.id();
      *number = sound;
    }
    EXPECT_EQ(entrant.solve(steps(10, {1})).status, Status::ok) << entrant.info.id();
  }
  // h w = 22 grows by 500 a step: past 1e100 within 40 steps, well before the end.
  const Stage stiff = oscillator();
  for (const char* method : {"soft_body_force", "deformable_explicit"}) {
    const Outcome outcome = stiff[method].solve(steps(1000, {10000}));
    EXPECT_EQ(outcome.status, Status::non_finite) << method;
    EXPECT_NE(outcome.detail, "");
    EXPECT_LT(outcome.t, 10000);
  }
  // Each step multiplies by 9, and damping divides by 51 after Bullet's clamp: such a run, once
  // clamped, stays bounded, and must not be reported as stable.
  EXPECT_EQ(oscillator(10)["deformable_explicit"].solve(steps(1000, {10000})).status,
            Status::non_finite);
}

TEST(BulletFault, KeepsTheBudgetAndSeesAStepThatBulletIgnores) {
  const Stage stage = oscillator();
  Request small = steps(100, {1});
  small.budget.evaluations = 10;
  for (const Entrant& entrant : stage.entrants) {
    if (needs_contacts(entrant)) continue;
    const Outcome outcome = entrant.solve(small);
    EXPECT_EQ(outcome.status, Status::over_budget) << entrant.info.id();
    EXPECT_EQ(outcome.counters.steps, 10u);
    EXPECT_EQ(entrant.solve(steps(1, {1e-17})).status, Status::step_too_small) << entrant.info.id();
  }
}

TEST(BulletFault, ProductsInLinearSolversAreCounted) {
  const scene::Scene scene = chain();
  const Stage stage = bullet_tests::stage<18>(scene, state_of(scene));
  Request request = steps(10, {1});
  EXPECT_EQ(stage["soft_body_force"].solve(request).counters.products, 0u);
  const std::uint64_t whole = stage["deformable_implicit"].solve(request).counters.products;
  EXPECT_GE(whole, 20u);
  request.options = {{"sweeps", 1}};
  EXPECT_LT(stage["deformable_implicit"].solve(request).counters.products, whole);
}

TEST(BulletFault, ThreadsDoNotDisturbEachOther) {
  const Stage first = oscillator(), second = oscillator(1, 0.5);
  for (std::size_t e = 0; e < first.entrants.size(); ++e) {
    if (needs_contacts(first.entrants[e])) continue;
    const Request request = steps(2000, {1, 2});
    const auto alone = std::array{first.entrants[e].solve(request).states,
                                  second.entrants[e].solve(request).states};
    std::array<std::vector<double>, 2> together;
    const auto race = [&](std::size_t which, const Entrant& entrant) {
      for (int i = 0; i < 5; ++i) together[which] = entrant.solve(request).states;
    };
    std::thread other(race, 1, std::cref(second.entrants[e]));
    race(0, first.entrants[e]);
    other.join();
    EXPECT_EQ(together, alone) << first.entrants[e].info.id();
  }
}

}  // namespace
}  // namespace odeum::bullet_tests::bullet_fault_test
