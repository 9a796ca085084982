// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/step_matrix.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/catalogue.hpp"

namespace odeum::judge::step_matrix_test {
namespace {

StepMatrix step_of(const std::string& id, const std::string& solver, double h) {
  for (const Solver& each : all_solvers())
    if (each.info.id() == solver) return measure_step_matrix(tests::find_case(id), each, h);
  throw std::logic_error("no solver " + solver);
}

// u_1 = (I + h A) u_0 and (I - h A)^-1 u_0 with K/m = 5: of modulus sqrt(1 + 5 h^2) and its
// inverse.
TEST(StepMatrix, OfEulersMethodsOnASpring) {
  const double h = 0.1, modulus = std::sqrt(1 + 5 * h * h);
  const StepMatrix forward = step_of("damped_oscillator_undamped", "odeum/explicit_euler", h);
  const double expected[] = {1, 0.1, -0.5, 1};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(forward.matrix[k], expected[k], 1e-15);
  EXPECT_NEAR(forward.powers.radius, modulus, 1e-14);
  EXPECT_LT(forward.rest, 1e-14);
  EXPECT_EQ(consequence(forward.powers, 100).substr(0, 27), "diverges as 1.024695077^n: ");
  const StepMatrix backward = step_of("damped_oscillator_undamped", "odeum/implicit_euler", h);
  EXPECT_NEAR(backward.powers.radius, 1 / modulus, 1e-12);
  const StepMatrix symplectic = step_of("damped_oscillator_undamped", "odeum/symplectic_euler", h);
  EXPECT_EQ(consequence(symplectic.powers, 100), "stays bounded");
}

TEST(StepMatrix, OfFreeFallGrowsLikeTheSolution) {
  const StepMatrix step = step_of("free_fall", "odeum/explicit_euler", 0.1);
  EXPECT_NEAR(step.vector[1], -0.981, 1e-15);
  EXPECT_EQ(consequence(step.powers, 100), "grows as n");
}

TEST(StepMatrix, AMultistepMethodIsNone) {
  EXPECT_GT(step_of("damped_oscillator_undamped", "odeum/bdf2", 0.1).rest, 1e-3);
}

// A rotation by an angle that is not a part of a circle, a triple eigenvalue 1, and growth that
// only many steps show.
TEST(Powers, TellBoundedPolynomialAndExponentialGrowth) {
  const double c = std::cos(0.3), s = std::sin(0.3);
  EXPECT_EQ(consequence(powers_of({c, -5 * s, s / 5, c}, 2), 10), "stays bounded");
  EXPECT_EQ(consequence(powers_of({1, 1, 0, 0, 1, 1, 0, 0, 1}, 3), 10), "grows as n^2");
  EXPECT_EQ(consequence(powers_of({1 + 1e-9}, 1), 1000),
            "diverges as (1 + 1e-09)^n: by a factor of 1 in 1000 steps");
  EXPECT_EQ(consequence(powers_of({0.5}, 1), 2), "decays as 0.5^n: by a factor of 0.25 in 2 steps");
}

}  // namespace
}  // namespace odeum::judge::step_matrix_test
