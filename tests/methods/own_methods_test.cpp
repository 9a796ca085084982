// SPDX-License-Identifier: BSD-3-Clause
// The contract of every own method: failures reported, budgets kept, costs counted.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/catalogue.hpp"
#include "support/field.hpp"

namespace odeum::tests::own_methods_test {
namespace {

double one(double, double) { return 1; }

double time_in(const std::string& detail) {
  return std::stod(detail.substr(detail.rfind("t = ") + 4));
}

template <int sign>
double bad_after(double t, double q) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  return t <= 0.3 ? t + q : sign == 0 ? std::numeric_limits<double>::quiet_NaN() : sign * inf;
}

TEST(OwnMethods, ReportANonFiniteRightHandSideWithItsTimeAndComponent) {
  for (const auto& [bad, name] :
       {std::pair{&bad_after<0>, "nan"}, {&bad_after<1>, "inf"}, {&bad_after<-1>, "-inf"}}) {
    for (const Entrant& entrant : own_methods_on({bad, one, one}, 0, {1, 0})) {
      ASSERT_TRUE(entrant.solve) << entrant.info.id() << ": " << entrant.unfit;
      for (const Mode mode : {Mode::fixed, Mode::adaptive}) {
        if (!(mode == Mode::fixed ? entrant.info.fixed : entrant.info.adaptive)) continue;
        SCOPED_TRACE(entrant.info.id() + " " + to_string(mode) + " " + name);
        const Outcome outcome = entrant.solve(mode == Mode::fixed ? fixed_request(10, {1})
                                                                  : adaptive_request(1e-5, {1}));
        // The state of an explicit method is not finite; Newton's method fails; steps shrink.
        EXPECT_TRUE(mode == Mode::adaptive ? outcome.status == Status::step_too_small
                                           : outcome.status == Status::non_finite ||
                                                 outcome.status == Status::newton_failed)
            << to_string(outcome.status);
        const std::string expected =
            std::string("first non-finite value: right-hand side component 1 is ") + name;
        EXPECT_NE(outcome.detail.find(expected), std::string::npos) << outcome.detail;
        const double t = time_in(outcome.detail);
        EXPECT_GT(t, 0.3);
        EXPECT_LE(t, mode == Mode::fixed ? 0.4 + 1e-12 : 1);  // in the step that meets it first
        // A row that evaluates at the start of a step only may end one step beyond t.
        EXPECT_LE(outcome.t, t + 0.01) << "the last state that is good";
        EXPECT_TRUE(outcome.states.empty()) << "no stop was reached";
      }
    }
  }
}

TEST(OwnMethods, ReportAStartThatIsBadAtOnce) {
  for (const Entrant& entrant : own_methods_on({bad_after<0>, one, one}, 5, {1, 0})) {
    if (!entrant.info.fixed) continue;
    const Outcome outcome = entrant.solve(fixed_request(10, {6}));
    EXPECT_TRUE(outcome.status == Status::non_finite || outcome.status == Status::newton_failed)
        << entrant.info.id() << to_string(outcome.status);
    EXPECT_NE(outcome.detail.find("is nan at t = 5"), std::string::npos) << outcome.detail;
  }
}

TEST(OwnMethods, StopAtTheirBudget) {
  const auto sum = [](double t, double q) { return t + q; };
  for (const Entrant& entrant : own_methods_on({sum, one, one}, 0, {1, 0})) {
    if (!entrant.info.fixed) continue;
    Request request = fixed_request(1000, {1});
    request.budget.evaluations = 100;
    const Outcome outcome = entrant.solve(request);
    EXPECT_EQ(outcome.status, Status::over_budget) << entrant.info.id();
    EXPECT_EQ(outcome.counters.rhs_evaluations, 100U) << entrant.info.id();
    EXPECT_LT(outcome.t, 0.11) << entrant.info.id();
  }
}

TEST(OwnMethods, CountTheirEvaluations) {
  struct Cost {
    std::uint64_t a_step, to_start, jacobians;
  };
  // The problem is linear: implicit Euler needs one correction and one check, with one Jacobian for
  // all steps.
  const std::map<std::string, Cost> costs{{"explicit_euler", {1, 0, 0}},
                                          {"midpoint", {2, 0, 0}},
                                          {"heun", {2, 0, 0}},
                                          {"rk4", {4, 0, 0}},
                                          {"cash_karp54", {6, 0, 0}},
                                          {"dormand_prince54", {6, 0, 0}},
                                          {"dormand_prince853", {12, 0, 0}},
                                          {"verner98", {16, 0, 0}},
                                          {"gragg_bulirsch_stoer", {21, 0, 0}},
                                          {"yoshida4", {3, 1, 0}},
                                          {"mclachlan_atela4", {4, 0, 0}},
                                          {"blanes_moan6", {11, 1, 0}},
                                          {"dormand_nystroem64", {6, 0, 0}},
                                          {"symplectic_euler", {1, 0, 0}},
                                          {"symplectic_euler_position_first", {1, 0, 0}},
                                          {"velocity_verlet", {1, 1, 0}},
                                          {"leapfrog", {1, 1, 0}},
                                          {"stormer_verlet", {1, 1, 0}},
                                          {"implicit_euler", {2, 0, 1}},
                                          {"implicit_euler_linearised", {1, 0, 16}}};
  std::size_t checked = 0;
  const auto sum = [](double t, double q) { return t + q; };
  for (const Entrant& entrant : own_methods_on({sum, one, one}, 0, {1, 0})) {
    const auto cost = costs.find(entrant.info.method);
    if (cost == costs.end()) continue;
    const Outcome outcome = entrant.solve(fixed_request(16, {0.5, 1}));
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    const auto& [a_step, to_start, jacobians] = cost->second;
    EXPECT_EQ(outcome.counters.steps, 16U) << entrant.info.id();
    EXPECT_EQ(outcome.counters.rhs_evaluations, 16 * a_step + to_start) << entrant.info.id();
    EXPECT_EQ(outcome.counters.jacobian_evaluations, jacobians) << entrant.info.id();
    ++checked;
  }
  EXPECT_EQ(checked, costs.size());
}

TEST(OwnMethods, ThatDoNotFitSayWhatTheyNeed) {
  int unfit = 0;
  for (const Case& c : all_cases())
    for (const Entrant& entrant : c.entrants) {
      EXPECT_EQ(entrant.unfit.empty(), static_cast<bool>(entrant.solve)) << entrant.info.id();
      if (entrant.info.library != "odeum" || entrant.unfit.empty()) continue;
      EXPECT_EQ(entrant.unfit, "needs " + entrant.info.needs);
      EXPECT_FALSE(entrant.info.needs.empty()) << entrant.info.id();
      ++unfit;
    }
  EXPECT_GT(unfit, 0);
}

}  // namespace
}  // namespace odeum::tests::own_methods_test
