// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sundials/sundials_config.h>

#include <algorithm>
#include <map>
#include <set>

#include "adapters/sundials_problems.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/solvers/case.hpp"
#include "sundials/arkode.hpp"

namespace odeum::sundials_tests::sundials_order_test {
namespace {

// Before version 7 ERKStep treats every table with c_s = 1 as first same as last
// (reports/findings/sundials.md), and these tables lose their order.
const std::map<std::string, double> orders_of_erkstep_6{{"erkstep_ark324l2sa_erk_4_2_3", 2},
                                                        {"erkstep_ark436l2sa_erk_6_3_4", 3},
                                                        {"erkstep_sayfy_aburub_6_3_4", 2},
                                                        {"erkstep_ark548l2sa_erk_8_4_5", 3},
                                                        {"erkstep_verner_8_5_6", 3},
                                                        {"erkstep_fehlberg_13_7_8", 7},
                                                        {"erkstep_user_rk4", 3}};

double order_to_expect(const SolverInfo& info) {
  if (SUNDIALS_VERSION_MAJOR < 7) {
    const auto it = orders_of_erkstep_6.find(info.method);
    if (it != orders_of_erkstep_6.end()) return it->second;
  }
  return info.order;
}

TEST(SundialsCatalogue, HoldsEveryTableOfTheEnumerations) {
  using namespace adapters::sundials;
  const auto& erk = explicit_tables();
  ASSERT_EQ(erk.size(), static_cast<std::size_t>(ARKODE_MAX_ERK_NUM - ARKODE_MIN_ERK_NUM + 1));
  for (std::size_t i = 0; i < erk.size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(erk[i].id), ARKODE_MIN_ERK_NUM + i) << erk[i].name;
  const auto& dirk = implicit_tables();
  ASSERT_EQ(dirk.size(), static_cast<std::size_t>(ARKODE_MAX_DIRK_NUM - ARKODE_MIN_DIRK_NUM + 1));
  for (std::size_t i = 0; i < dirk.size(); ++i)
    EXPECT_EQ(static_cast<std::size_t>(dirk[i].id), ARKODE_MIN_DIRK_NUM + i) << dirk[i].name;
}

TEST(SundialsCatalogue, NamesAreUniqueAndEverySolverFits) {
  std::set<std::string> ids;
  for (const Entrant& entrant : entrants<WitchWithoutJacobian>({1, 0})) {
    EXPECT_TRUE(ids.insert(entrant.info.id()).second) << entrant.info.id();
    EXPECT_EQ(entrant.unfit, "");
    EXPECT_TRUE(entrant.info.fixed || entrant.info.adaptive) << entrant.info.id();
    EXPECT_NE(entrant.info.source, "");
  }
}

TEST(SundialsOrder, AtAFixedStepIsWhatTheTableClaims) {
  for (const Entrant& entrant : entrants<Witch>({1, 0})) {
    // The terms of the next orders are larger than those of Verner's most efficient pairs down to
    // rounding: sundials_later_tables_test.cpp.
    if (!entrant.info.fixed || entrant.info.method.find("_user_verner_") != std::string::npos)
      continue;
    // Slopes of successive halvings, from where the error is small enough to be asymptotic (1e-2)
    // to what lies above rounding and Newton's tolerance, or above the floor that coefficients of
    // 12 digits leave (the finding on Cash's tables).
    const bool few_digits = entrant.info.method.find("_cash_5_") != std::string::npos;
    const double floor = few_digits ? 1e-10 : 1e-12;
    std::vector<double> slopes;
    double previous = 0;
    for (std::uint64_t n = 8; n <= 2048; n *= 2) {
      const Outcome outcome = entrant.solve(fixed(n, {1, 2}));
      ASSERT_EQ(outcome.status, Status::ok) << entrant.info.id() << ": " << outcome.detail;
      const double error = Witch::error(2, outcome.states.data() + 2);
      if (error < floor) break;
      if (previous != 0 && previous < 1e-2) slopes.push_back(std::log2(previous / error));
      previous = error;
    }
    ASSERT_FALSE(slopes.empty()) << entrant.info.id();
    // The finest slope; a quarter of an order is less than what any wrong coefficient costs, and
    // half of one is allowed from order 5 on, where the window has few points.
    const double order = order_to_expect(entrant.info);
    EXPECT_NEAR(slopes.back(), order, order < 5 ? 0.25 : 0.5) << entrant.info.id();
  }
}

TEST(SundialsOrder, ErrorFallsWithTheTolerance) {
  for (const Entrant& entrant : entrants<Witch>({1, 0})) {
    if (!entrant.info.adaptive) continue;
    std::vector<double> errors;
    for (const double tolerance : {1e-3, 1e-5, 1e-7}) {
      const Outcome outcome = entrant.solve(adaptive(tolerance, {1, 2}));
      ASSERT_EQ(outcome.status, Status::ok) << entrant.info.id() << ": " << outcome.detail;
      errors.push_back(Witch::error(2, outcome.states.data() + 2));
      // A local tolerance becomes a global error within a factor of a thousand on this problem.
      EXPECT_LT(errors.back(), 1e3 * tolerance) << entrant.info.id() << " at " << tolerance;
    }
    // Four powers of ten in the tolerance; three are left for an error that happened to be small
    // at the start, or a pair whose error goes with a lower power of the tolerance.
    EXPECT_LT(errors[2], errors[0] / 10) << entrant.info.id();
  }
}

/// With the library's default settings it is not (reports/findings/sundials.md).
TEST(SundialsOrder, ErrorOfImplicitTablesIsControlledOnALinearProblem) {
  for (const Entrant& entrant : entrants<Rotation>({1, 0})) {
    if (entrant.info.family != "implicit_rk" || !entrant.info.adaptive) continue;
    if (entrant.info.method.ends_with("_default_settings")) continue;
    for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
      const Outcome outcome = entrant.solve(adaptive(tolerance, {1, 2, 5}));
      ASSERT_EQ(outcome.status, Status::ok) << entrant.info.id() << ": " << outcome.detail;
      // Steps of some tolerance^(1 / (p + 1)), each with an error of one tolerance, on ten radians.
      const double sum = 10 * std::pow(tolerance, entrant.info.order / (entrant.info.order + 1));
      EXPECT_LT(Rotation::error(5, outcome.states.data() + 4), sum)
          << entrant.info.id() << " at " << tolerance;
    }
  }
}

/// The largest relative difference between two solvers' states on a case.
double difference(const Case& c, const std::string& one, const std::string& other) {
  const Request request = fixed(c.settings.coarsest_steps * 4, c.stops);
  const Outcome a = c.entrants.find(one)->solve(request);
  const Outcome b = c.entrants.find(other)->solve(request);
  EXPECT_EQ(a.status, Status::ok) << one << ": " << a.detail;
  EXPECT_EQ(b.status, Status::ok) << other << ": " << b.detail;
  if (a.states.size() != b.states.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < a.states.size(); ++i)
    largest = std::max(largest,
                       std::abs(a.states[i] - b.states[i]) / std::max(1.0, std::abs(b.states[i])));
  return largest;
}

TEST(SundialsUserTable, StepsAsOurOwnMethodDoes) {
  for (const Case& c : all_cases()) {
    if (c.id != "lotka_volterra" && c.id != "rc_circuit") continue;
    for (const std::string id : {"explicit_euler", "midpoint", "heun", "rk4", "cash_karp54"}) {
      // Some hundred steps with rounding of 1e-16 each, amplified on the way; the library sums up
      // its time, where ours multiplies.
      const double rounding = 1e-11;
      EXPECT_LT(difference(c, "arkode/arkstep_user_" + id, "odeum/" + id), rounding)
          << c.id << ' ' << id;
      const double by_erkstep = difference(c, "arkode/erkstep_user_" + id, "odeum/" + id);
      if (SUNDIALS_VERSION_MAJOR < 7 && (id == "heun" || id == "rk4"))
        EXPECT_GT(by_erkstep, 1e-6) << "the finding on ERKStep would be gone: " << c.id;
      else
        EXPECT_LT(by_erkstep, rounding) << c.id << ' ' << id;
    }
  }
}

// The library's coefficients and the papers', of two implementations.
TEST(SundialsImex, StepsAsOurOwnMethodDoes) {
  for (const Case& c : all_cases()) {
    if (c.id != "brusselator2" && c.id != "vdp_mu1") continue;
    for (const auto& [theirs, own] : {std::pair{"user_ars222", "ars222"},
                                      {"user_ars443", "ars443"},
                                      {"ark324l2sa_4_2_3", "ark32_kennedy_carpenter"},
                                      {"ark436l2sa_6_3_4", "ark43_kennedy_carpenter"}})
      // Newton's iteration to 1e-14 there and to rounding here, in some thousand stages.
      EXPECT_LT(
          difference(c, std::string("arkode/arkstep_imex_") + theirs, std::string("odeum/") + own),
          1e-9)
          << c.id << ' ' << own;
  }
}

TEST(SundialsImex, NeedsAProblemThatSaysItsParts) {
  Contest<Rotation> contest;
  contest.problem = std::make_shared<const Rotation>();
  contest.y0 = std::make_shared<const std::vector<double>>(std::vector<double>{1, 0});
  int found = 0;
  for (const Entrant& entrant : tests::enrolled_on(erase(contest), adapters::sundials::add_solvers))
    if (entrant.info.family == "imex_rk") {
      EXPECT_NE(entrant.unfit.find("split into an explicit and an implicit part"),
                std::string::npos)
          << entrant.unfit;
      ++found;
    }
  EXPECT_GE(found, 4);
}

// ARKODE's steps ended on each of them: 60 outputs made of a run of 20 steps one of 65. Its
// implicit stages are predicted by the interpolant, which outputs would need another of.
TEST(SundialsRun, OutputsDoNotChangeItsSteps) {
  std::vector<double> stops;
  for (int k = 1; k <= 60; ++k) stops.push_back(k * 0.05);
  for (const Entrant& entrant : entrants<Witch>({1, 0})) {
    if (!entrant.info.adaptive || entrant.info.family == "implicit_rk" ||
        entrant.info.family == "imex_rk")
      continue;
    Request request = adaptive(1e-5, stops);
    request.over_stops = true;
    const Outcome with = entrant.solve(request),
                  without = entrant.solve(adaptive(1e-5, {stops.back()}));
    ASSERT_EQ(with.status, Status::ok) << entrant.info.id() << ": " << with.detail;
    EXPECT_EQ(with.counters.steps, without.counters.steps) << entrant.info.id();
    ASSERT_EQ(with.states.size(), 120u) << entrant.info.id();
    for (std::size_t i = 0; i < 2; ++i)
      EXPECT_EQ(with.states[118 + i], without.states[i]) << entrant.info.id();
    for (std::size_t stop = 0; stop < stops.size(); ++stop)  // of degree 5, over steps of 0.2
      EXPECT_LT(Witch::error(stops[stop], with.states.data() + 2 * stop), 1e-3)
          << entrant.info.id() << " at " << stops[stop];
  }
}

}  // namespace
}  // namespace odeum::sundials_tests::sundials_order_test
