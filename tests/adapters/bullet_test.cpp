// SPDX-License-Identifier: BSD-3-Clause
// The scheme of each solver of the Bullet adapter: its order, and its closed form where it has one.
#include <gtest/gtest.h>

#include <algorithm>

#include "adapters/bullet_stage.hpp"
#include "odeum/problem/damped_oscillator.hpp"
#include "odeum/scene/problem/scene_problem.hpp"

namespace odeum::bullet_tests::bullet_test {
namespace {

struct Course {
  const char* name;
  Stage (*make)();
  double horizon;
  void (*truth)(double t, double* y);
  std::vector<const char*> methods;
};

const Course courses[] = {
    {"undamped",
     [] { return oscillator(); },
     2,
     [](double t, double* y) { damped_oscillator_solution(2, 0, 10, 1, 0, t, y); },
     {"soft_body_force", "soft_body_links", "deformable_explicit", "deformable_implicit"}},
    {"damped",
     [] { return oscillator(1); },
     2,
     [](double t, double* y) { damped_oscillator_solution(2, 1, 10, 1, 0, t, y); },
     {"soft_body_force", "soft_body_links", "deformable_explicit", "deformable_implicit"}},
    {"free_fall",
     [] { return free_fall(); },
     2,
     [](double t, double* y) {
       y[0] = 10 + t * (3 - 9.81 * t / 2);
       y[1] = 3 - 9.81 * t;
     },
     {"soft_body_force", "soft_body_links", "deformable_explicit", "deformable_implicit"}},
    {"decay",
     [] { return medium(-1); },
     2,
     [](double t, double* y) {
       y[0] = std::exp(-t);
       y[1] = 0;
     },
     {"soft_body_force", "soft_body_links", "deformable_explicit", "deformable_implicit"}},
    {"rotation",
     [] {
       return medium({-0.5, 2});
     },
     2,
     [](double t, double* y) {
       const auto exact = std::exp(std::complex<double>(-0.5, 2) * t);
       y[0] = exact.real();
       y[1] = exact.imag();
     },
     {"soft_body_force"}},
};

TEST(Bullet, EveryEntryIsOfOrderOne) {
  for (const Course& course : courses) {
    const Stage stage = course.make();
    for (const char* method : course.methods) {
      double last = 0;
      for (std::uint64_t n = 640; n <= 10240; n *= 2) {
        const Outcome outcome = stage[method].solve(steps(n, {course.horizon}));
        ASSERT_EQ(outcome.status, Status::ok) << course.name << " " << method << outcome.detail;
        EXPECT_EQ(outcome.counters.steps, n);
        double y[2];
        course.truth(course.horizon, y);
        const double error = std::hypot(outcome.states[0] - y[0], outcome.states[1] - y[1]);
        // At 640 steps and more the next term of the expansion in h is some hundredths of the
        // first, and the error stays above 1e-5, far from the 1e-7 that the float step costs.
        if (last > 0) {
          EXPECT_NEAR(std::log2(last / error), 1, 0.06) << course.name << " " << method << " " << n;
        }
        last = error;
      }
    }
  }
}

TEST(Bullet, FreeFallIsSymplecticEulerWithTheStepRoundedToFloat) {
  const std::uint64_t n = 20;
  const double h = 0.1, count = 20;
  const auto closed_form = [&](double step) {
    return 10 + count * step * 3 - 9.81 * step * step * count * (count + 1) / 2;
  };
  const Stage stage = free_fall();
  const double rounded = closed_form(static_cast<double>(static_cast<float>(h)));
  // Sums of 20 doubles near 10: 1e-13 holds a few roundings each.
  const double rounding = 1e-13;
  const Outcome force = stage["soft_body_force"].solve(steps(n, {2}));
  EXPECT_NEAR(force.states[0], rounded, rounding);
  EXPECT_GT(std::abs(rounded - closed_form(h)), 1e-8);  // so the two can be told apart
  for (const char* method : {"deformable_explicit", "deformable_implicit"})
    EXPECT_NEAR(stage[method].solve(steps(n, {2})).states[0], closed_form(h), rounding) << method;
}

TEST(Bullet, ForcesOnAMediumAreExplicitEuler) {
  const std::complex<double> lambda(-0.5, 2);
  const auto h = static_cast<double>(static_cast<float>(0.1));
  const auto exact = std::pow(1.0 + h * lambda, 10);
  const Outcome outcome = medium(lambda)["soft_body_force"].solve(steps(10, {1}));
  EXPECT_NEAR(outcome.states[0], exact.real(), 1e-14);  // ten products of doubles
  EXPECT_NEAR(outcome.states[1], exact.imag(), 1e-14);
  EXPECT_EQ(outcome.counters.rhs_evaluations, 10u);
}

TEST(Bullet, DampingIsBackwardEulerInEveryEntryWithItsOwn) {
  const double exact = std::pow(1 / 1.1, 10);
  const Stage stage = medium(-1);
  // Links compute the velocity as a difference of positions near 1 over h = 0.1: 1e-15 / 0.1 per
  // step.
  for (const char* method : {"soft_body_links", "deformable_explicit", "deformable_implicit"}) {
    const Outcome outcome = stage[method].solve(steps(10, {1}));
    EXPECT_NEAR(outcome.states[0], exact, 1e-13) << method;
    EXPECT_EQ(outcome.counters.rhs_evaluations, 0u) << "the engine's own are not ours to count";
  }
}

TEST(Bullet, ImplicitIsBackwardEulerOnALinearSpring) {
  const double h = 0.1, k = 10, d = 1, m = 2;
  double x = 1, v = 0;
  for (int i = 0; i < 20; ++i) {
    v = (m * v - h * k * x) / (m + h * d + h * h * k);
    x += h * v;
  }
  const Outcome outcome = oscillator(d)["deformable_implicit"].solve(steps(20, {2}));
  // One unknown: conjugate gradients are exact, to rounding of about 1e-16 a step.
  EXPECT_NEAR(outcome.states[0], x, 1e-14);
  EXPECT_NEAR(outcome.states[1], v, 1e-14);
}

TEST(Bullet, ALinkHasALawOfItsOwn) {
  const double h = 1.0 / 4096, k = 10, m = 2, l = 1, rest = 0.5;
  const Outcome outcome = oscillator(0, rest)["soft_body_links"].solve(steps(1, {h}));
  const double law = -k / m * l * (l * l - rest * rest) / (l * l + rest * rest);
  // Backward Euler's own error over one step from rest is a share h^2 k/m = 3e-7 of it.
  EXPECT_NEAR(outcome.states[1] / h, law, 1e-6 * std::abs(law));
  EXPECT_GT(std::abs(law + k / m * (l - rest)), 0.1);  // the spring's would have been 2.5
}

TEST(Bullet, AChainDrivenByForcesIsSymplecticEuler) {
  const scene::Scene scene = chain();
  const scene::SceneProblem problem(scene);
  const auto h = static_cast<double>(static_cast<float>(0.01));
  auto y = state_of(scene);
  for (int i = 0; i < 100; ++i) {
    double a[9];
    problem.acceleration(0, y.data(), y.data() + 9, a);
    for (std::size_t k = 0; k < 9; ++k) y[9 + k] += h * a[k];
    for (std::size_t k = 0; k < 9; ++k) y[k] += h * y[9 + k];
  }
  const Outcome outcome =
      stage<18>(scene, state_of(scene))["soft_body_force"].solve(steps(100, {0.25, 0.5, 1}));
  ASSERT_EQ(outcome.states.size(), 54u);
  // 100 steps of rounding errors of 1e-16, which this mild motion grows a little.
  for (std::size_t k = 0; k < 18; ++k) EXPECT_NEAR(outcome.states[36 + k], y[k], 1e-12) << k;
}

/// The end of a second by the classical Runge-Kutta method on the scene's own equation, its error
/// 1e-9 by the factor 16 on halving the step.
std::array<double, 18> end_of(const scene::Scene& scene) {
  const scene::SceneProblem problem(scene);
  auto y = state_of(scene);
  const double h = 1.0 / 1000;
  for (int i = 0; i < 1000; ++i) {
    std::array<std::array<double, 18>, 4> k{};
    auto at = y;
    for (std::size_t s = 0; s < 4; ++s) {
      problem.rhs(0, at.data(), k[s].data());
      for (std::size_t j = 0; j < 18; ++j) at[j] = y[j] + (s == 2 ? h : h / 2) * k[s][j];
    }
    for (std::size_t j = 0; j < 18; ++j)
      y[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
  }
  return y;
}

/// Halves the step twice: the second term of the error is a few hundredths of the first.
void expect_order_one(const scene::Scene& scene, std::initializer_list<const char*> methods) {
  const Stage stage = bullet_tests::stage<18>(scene, state_of(scene));
  const auto y = end_of(scene);
  for (const char* method : methods) {
    ASSERT_EQ(stage[method].unfit, "") << method;
    double last = 0;
    for (const std::uint64_t n : {4096, 8192, 16384}) {
      const Outcome outcome = stage[method].solve(steps(n, {1}));
      ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
      double error = 0;
      for (std::size_t j = 0; j < 18; ++j)
        error = std::max(error, std::abs(outcome.states[j] - y[j]));
      if (last > 0) {
        EXPECT_NEAR(std::log2(last / error), 1, 0.06) << method << " " << n;
      }
      last = error;
    }
  }
}

TEST(Bullet, DeformableChainsConvergeToTheSceneTheyWereGiven) {
  expect_order_one(chain(), {"deformable_explicit", "deformable_implicit"});
}

// Each kind of spring has a force object of its own; Bullet's addForce would drop the second.
TEST(Bullet, SpringsOfSeveralKindsKeepTheirOwnForces) {
  scene::Scene scene = chain();
  scene.springs[1].stiffness = 60;
  scene.springs[1].damping = 0.9;
  scene.springs[1].axial = true;
  expect_order_one(scene, {"soft_body_force", "deformable_explicit", "deformable_implicit"});
}

TEST(Bullet, TermsThatItLacksAreForcesOnItsNodes) {
  scene::Scene scene = chain();
  scene.forces = {scene::Wind{.velocity = {3, 0, 1}, .coefficient = 0.2},
                  scene::QuadraticDrag{.coefficient = 0.05},
                  scene::MagneticField{.field = {0, 0, 1}, .charge = 0.5}};
  expect_order_one(scene, {"soft_body_force", "deformable_explicit", "deformable_implicit"});
  scene::PlaneContact floor;
  floor.stiffness = 200;
  floor.damping = 1;
  floor.point = {0, -1, 0};
  floor.normal = {0, 1, 0};
  scene.contacts = {floor};
  const Stage stage = bullet_tests::stage<18>(scene, state_of(scene));
  scene.contacts.clear();
  const Stage without = bullet_tests::stage<18>(scene, state_of(scene));
  for (const char* method :
       {"soft_body_force", "soft_body_links", "deformable_explicit", "deformable_implicit"}) {
    // The second particle falls through where the floor is not.
    EXPECT_LT(without[method].solve(steps(2000, {1})).states[7], -1.5) << method;
    EXPECT_GT(stage[method].solve(steps(2000, {1})).states[7], -1.5) << method;
  }
}

// Friction takes its coefficient of the sliding at each step, whatever the force: a ball at 1 m/s,
// which Coulomb's friction stops after 0.1 m, stops after some steps of 1 mm.
TEST(Bullet, ItsOwnCollisionsStopWithoutARebound) {
  scene::Scene scene;
  scene.gravity = {0, 0, -10};
  scene.particles = {{.position = {0, 0, 0.3}, .mass = 1, .radius = 0.05}};
  scene::PlaneContact floor;
  floor.normal = {0, 0, 1};
  floor.stiffness = 1;  // not of this model
  scene.contacts = {floor};
  const auto end = [&](double t) {
    std::array<double, 6> y0{};
    for (std::size_t d = 0; d < 3; ++d) {
      y0[d] = scene.particles[0].position[d];
      y0[3 + d] = scene.particles[0].velocity[d];
    }
    const Stage stage = bullet_tests::stage<6>(scene, y0);
    EXPECT_EQ(stage["soft_body_collision"].unfit, "");
    const Outcome outcome = stage["soft_body_collision"].solve(steps(1000, {t}));
    EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
    return outcome.states;
  };
  // Bullet leaves a part of the margin free, and its grid of distances is interpolated.
  EXPECT_NEAR(end(2)[2], 0.05, 0.02);
  EXPECT_NEAR(end(2)[5], 0, 1e-3);
  scene.particles[0].position[2] = 0.05;
  scene.particles[0].velocity = {1, 0, 0};
  floor.friction = 0.5;
  scene.contacts = {floor};
  EXPECT_NEAR(end(1)[3], 0, 1e-6);
  EXPECT_GT(end(1)[0], 0);
  EXPECT_LT(end(1)[0], 0.01);
  scene.contacts.emplace_back(scene::ParticleContact{});
  EXPECT_NE(bullet_tests::stage<6>(scene, {})["soft_body_collision"].unfit, "");
}

}  // namespace
}  // namespace odeum::bullet_tests::bullet_test
