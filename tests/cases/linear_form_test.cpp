// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/linear_form.hpp"

#include <gtest/gtest.h>

#include "odeum/cases/modal_solution.hpp"
#include "support/catalogue.hpp"

namespace odeum::cases::linear_form_test {
namespace {

TEST(LinearForm, OfFreeFallIsThatOfTheSlides) {
  const auto form = linear_form(tests::find_case("free_fall"));
  ASSERT_TRUE(form);
  EXPECT_EQ(text_of_matrix(form->a, 2), "[0 1; 0 0]");
  EXPECT_EQ(text_of_matrix(form->b, 1), "[0; -9.81]");
  EXPECT_EQ(text_of_eigenvalues(form->eigenvalues), "0 (2 times)");
  EXPECT_EQ(form->solution[0], "10 + 3*t - 4.905*t^2");
  EXPECT_EQ(form->solution[1], "3 - 9.81*t");
}

TEST(LinearForm, ADoubleEigenvalueHasATermWithT) {
  const auto form = linear_form(tests::find_case("damped_oscillator_critical"));
  ASSERT_TRUE(form);
  EXPECT_EQ(form->solution[1], "25*t*exp(-2.236067977*t)");
  EXPECT_EQ(text_of_eigenvalues(form->eigenvalues), "-2.23606798 (2 times)");
}

TEST(LinearForm, NeedsAConstantMatrix) {
  EXPECT_FALSE(linear_form(tests::find_case("lotka_volterra")));
  EXPECT_FALSE(linear_form(tests::find_case("heat_2d"))) << "more unknowns than are shown";
  const auto circuit = linear_form(tests::find_case("rc_circuit"));
  ASSERT_TRUE(circuit);
  EXPECT_TRUE(circuit->b_varies);
  EXPECT_TRUE(circuit->solution.empty());
}

// z1' = -z1 + z2, z2' = -1e6 z2: the slow mode is told from the fast one, of 1e6 times its rate.
TEST(ModalSolution, KeepsASlowModeBesideAFastOne) {
  const auto texts = modal_solution({-1, 0, 0, -1e6}, {2, 3}, 2, 1, "t");
  ASSERT_EQ(texts.size(), 2U);
  EXPECT_EQ(texts[0], "2*exp(-1*t)");
  EXPECT_EQ(texts[1], "3*exp(-1000000*t)");
}

// A chain of four integrators: one eigenvalue four times, which a QR iteration splits.
TEST(ModalSolution, TakesAFourfoldEigenvalueAsOne) {
  const auto texts =
      modal_solution({1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1, 1, 0, 0, 0, 1}, {0, 0, 0, 6}, 1, 2, "t");
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(texts[0], "t^3*exp(1*t)");
}

}  // namespace
}  // namespace odeum::cases::linear_form_test
