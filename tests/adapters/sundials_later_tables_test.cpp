// SPDX-License-Identifier: BSD-3-Clause
#include "sundials/later_tables.hpp"

#include <gtest/gtest.h>

#include <set>

#include "adapters/sundials_problems.hpp"
#include "odeum/methods/verner98.hpp"
#include "odeum/tableau/interpreter.hpp"
#include "odeum/tableau/row_order.hpp"

/// Tables of SUNDIALS 7.3.0, as tables of the user in the release that is built.
namespace odeum::sundials_tests::sundials_later_tables_test {
namespace {

namespace tables = adapters::sundials;

// What users of a current release have as defaults, eleven of each: built in, or with coefficients
// of the adapter.
TEST(SundialsLaterTables, TheDefaultsBeforeAndSinceRelease73AreMarked) {
  std::set<std::string> before, since;
  for (const Entrant& entrant : entrants<Witch>({1, 0})) {
    if (entrant.info.method.ends_with("_default_settings")) continue;
    const std::string& source = entrant.info.source;
    const std::string method = entrant.info.method.substr(entrant.info.method.find('_') + 1);
    if (source.find("until SUNDIALS 7.2.1") != std::string::npos) before.insert(method);
    if (source.find("since SUNDIALS 7.3.0") != std::string::npos) since.insert(method);
  }
  EXPECT_EQ(before.size(), 11u);
  EXPECT_EQ(since.size(), 11u);
}

/// Both rows have the orders stated, as far as the rounding of the coefficients tells.
template <std::size_t S>
void expect_proven(const Tableau<S>& table) {
  const DynamicTableau<double> t = dynamic_tableau(table);
  EXPECT_EQ(order_of_row(t, t.b, double_rounding).order, table.order);
  EXPECT_EQ(order_of_row(t, t.b_hat, double_rounding).order, table.order_hat);
}

TEST(SundialsLaterTables, HaveTheOrdersStated) {
  expect_proven(tables::ralston_3_1_2);
  expect_proven(tables::sofroniou_spaletta_5_3_4);
  expect_proven(tables::tsitouras_7_4_5);
  expect_proven(tables::verner_9_5_6);
  expect_proven(tables::verner_10_6_7);
  expect_proven(tables::verner_13_7_8);
  expect_proven(tables::ark2_dirk_3_1_2);
}

FunctionProblem witch() {
  return {.unknowns = 2,
          .f = [](double t, const double* y, double* dydt) { Witch{}.rhs(t, y, dydt); },
          .f_y = [](double t, const double* y, double* j) { Witch{}.jacobian(t, y, j); },
          .f_t = {}};
}

/// The library steps as the formulas of the table say.
template <std::size_t S>
void expect_steps(const Tableau<S>& table, const std::string& method, double rounding = 1e-13) {
  const FunctionProblem problem = witch();
  const DynamicTableau<double> t = dynamic_tableau(table);
  TableauInterpreter interpreter(t, problem);
  std::vector<double> y{1, 0};
  constexpr int steps = 20;
  const double h = 2. / steps;
  for (int i = 0; i < steps; ++i) ASSERT_EQ(interpreter.step(i * h, h, y), Status::ok);
  const Outcome outcome =
      find(entrants<Witch>({1, 0}), "arkode/" + method).solve(fixed(steps, {2}));
  ASSERT_EQ(outcome.status, Status::ok) << method << ": " << outcome.detail;
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(outcome.states[i], y[i], rounding) << method;
}

// Twenty steps, with rounding of 1e-16 times weights of 1 to 10; the two tables with coefficients
// of 200 and weights of 176 and 32 round accordingly, and Newton's iteration ends at 1e-14.
TEST(SundialsLaterTables, StepAsTheirFormulasSay) {
  for (const std::string stepper : {"erkstep_", "arkstep_"}) {
    expect_steps(tables::ralston_3_1_2, stepper + "user_ralston_3_1_2");
    expect_steps(tables::sofroniou_spaletta_5_3_4, stepper + "user_sofroniou_spaletta_5_3_4");
    expect_steps(tables::tsitouras_7_4_5, stepper + "user_tsitouras_7_4_5");
    expect_steps(tables::verner_9_5_6, stepper + "user_verner_9_5_6", 1e-11);
  }
  expect_steps(tables::verner_10_6_7, "arkstep_user_verner_10_6_7");
  expect_steps(tables::verner_13_7_8, "arkstep_user_verner_13_7_8", 1e-12);
  expect_steps(methods::verner98_tableau, "arkstep_user_verner_16_8_9", 1e-12);
  expect_steps(tables::ark2_dirk_3_1_2, "arkstep_user_ark2_dirk_3_1_2", 1e-12);
}

// ERKStep of 6.4.1 would lose the order of these (reports/findings/sundials.md).
TEST(SundialsLaterTables, ErkstepHasThoseAloneThatItStepsRightly) {
  const auto list = entrants<Witch>({1, 0});
  for (const char* method : {"erkstep_user_verner_10_6_7", "erkstep_user_verner_13_7_8"})
    EXPECT_THROW(find(list, std::string("arkode/") + method), std::runtime_error);
}

}  // namespace
}  // namespace odeum::sundials_tests::sundials_later_tables_test
