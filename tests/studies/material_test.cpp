// SPDX-License-Identifier: BSD-3-Clause
// Stiffness and damping of springs under own methods, against their closed forms.
#include "odeum/studies/material/material.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "odeum/cases/catalogue.hpp"

namespace odeum::study::material_test {
namespace {

// The amplitude is 1e-5 m at heights of 1 m, known to 1e-16: 1e-11, which a fit makes 1e-9 at the
// finest step; systems of one unknown are solved to rounding.
constexpr double fitted = 1e-7;

Specimen undamped(Specimen specimen) {
  specimen.damping = 0;
  return specimen;
}

MaterialRow response(const Specimen& specimen, const char* id, double step,
                     const Iterations& iterations = {}) {
  const SceneStage stage(specimen.scene());
  return measure_response(specimen, stage, find_solver(stage.entrants, id), step, iterations);
}

TEST(Material, ASpecimenKnowsItself) {
  const Specimen one = one_mass(), chain = hanging_chain();
  EXPECT_NEAR(one.frequency(), 100, 1e-12);  // sqrt(1000 / 0.1)
  EXPECT_NEAR(one.damping_ratio(), 0.05, 1e-15);
  EXPECT_NEAR(one.sag(), 1e-4, 1e-18);
  EXPECT_NEAR(chain.sag(), 55e-4, 1e-16);
  // M x'' = -K x on the shape gives its frequency, at every mass.
  const std::vector<double> x = chain.shape();
  const double w = chain.frequency();
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double above = i > 0 ? x[i - 1] : 0, below = i + 1 < x.size() ? x[i + 1] : x[i];
    EXPECT_NEAR(chain.stiffness * (2 * x[i] - above - below), chain.mass * w * w * x[i], 1e-10);
  }
}

TEST(Material, BackwardEulerIsSoftAndDampedByItsAmplification) {
  const Specimen one = undamped(one_mass());
  for (const double h : {1.0 / 120, 1.0 / 480}) {
    // The roots are (1 +- i h w) / (1 + h^2 w^2).
    const double x = h * one.frequency(), turn = std::atan(x) / h,
                 fall = std::log1p(x * x) / (2 * h);
    const double omega_squared = turn * turn + fall * fall;
    for (const char* id : {"odeum/implicit_euler", "odeum/implicit_euler_linearised"}) {
      const MaterialRow row = response(one, id, h);
      EXPECT_EQ(row.status, "ok") << row.detail;
      EXPECT_NEAR(row.static_stiffness_ratio, 1, fitted) << id;
      // Newton's method stops at 1e-10 of 1 m.
      EXPECT_NEAR(row.dynamic_stiffness_ratio, omega_squared / 1e4, 1e-5) << id;
      EXPECT_NEAR(row.added_damping_ratio, fall / std::sqrt(omega_squared), 1e-5) << id;
      EXPECT_TRUE(std::isnan(row.damping)) << "nothing to compare with";
    }
  }
}

TEST(Material, SymplecticEulerAndVerletAreTooFastAndUndamped) {
  const Specimen one = undamped(one_mass());
  for (const double h : {1.0 / 60, 1.0 / 240, 1.0 / 960})
    for (const char* id : {"odeum/symplectic_euler", "odeum/velocity_verlet"}) {
      const double turn = 2 / h * std::asin(h * 50);  // of 100 rad/s
      const MaterialRow row = response(one, id, h);
      EXPECT_NEAR(row.dynamic_stiffness_ratio, turn * turn / 1e4, 1e-6) << id << h;
      EXPECT_NEAR(row.added_damping_ratio, 0, fitted) << id << h;
      EXPECT_NEAR(row.static_stiffness_ratio, 1, fitted);
    }
  EXPECT_EQ(response(one, "odeum/symplectic_euler", 1.0 / 30).status, "unstable");
}

TEST(Material, AChainIsJudgedByItsSlowestMode) {
  const Specimen chain = undamped(hanging_chain());
  const double h = 1.0 / 60, x = h * chain.frequency(), turn = std::atan(x) / h,
               fall = std::log1p(x * x) / (2 * h);
  const MaterialRow row = response(chain, "odeum/implicit_euler", h);
  EXPECT_NEAR(row.phase, x, 1e-15);
  // Ten unknowns, solved by Newton's method to 1e-10 of 1 m, at an amplitude of 5e-4 m.
  EXPECT_NEAR(row.dynamic_stiffness_ratio,
              (turn * turn + fall * fall) / (chain.frequency() * chain.frequency()), 1e-5);
  const MaterialRow damped = response(hanging_chain(), "odeum/velocity_verlet", 1.0 / 960);
  EXPECT_NEAR(damped.damping, 1, 1e-3);  // the error of order 2 is (h w)^2 of it
  EXPECT_EQ(response(chain, "odeum/velocity_verlet", 1.0 / 60).status, "unstable");
}

TEST(Material, WhoDoesNotIterateDoesNotLook) {
  const MaterialRow one = response(one_mass(), "odeum/implicit_euler", 1.0 / 60),
                    other = response(one_mass(), "odeum/implicit_euler", 1.0 / 60, {.sweeps = 7});
  EXPECT_EQ(one.dynamic_stiffness_ratio, other.dynamic_stiffness_ratio);
}

TEST(Material, WhatDoesNotFitSaysSo) {
  const MaterialRow row = response(one_mass(), "odeum/leapfrog", 1.0 / 60);
  EXPECT_EQ(row.status, "not_applicable");
  EXPECT_NE(row.detail, "");
}

TEST(CommonUse, IsThatOfOneExplicitRungeKuttaMethodOfALibrary) {
  std::map<std::pair<std::string, CommonUse>, std::vector<std::string>> found;
  int engines = 0;
  for (const Entrant& entrant : known_case("cloth11_two_way").entrants) {
    const SolverInfo& info = entrant.info;
    engines += info.common_use == CommonUse::engine;
    if (info.common_use == CommonUse::none || info.family != "explicit_rk") continue;
    found[{info.library, info.common_use}].push_back(info.method);
    EXPECT_TRUE(info.common_use == CommonUse::tolerance ? info.adaptive : info.fixed) << info.id();
  }
  // A copy of another method's info would add a second one.
  for (const auto& [use, methods] : found) EXPECT_EQ(methods.size(), 1U) << methods.back();
  EXPECT_GE(found.size(), 2U);
  EXPECT_GE(engines, 4) << "own ones, those of a physics engine besides";
}

}  // namespace
}  // namespace odeum::study::material_test
