// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/guard.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>
#include <thread>

#include "odeum/core/guarded.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::guard_test {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Three components; the second is not finite after t = 1.
struct TurnsBad {
  static constexpr std::size_t dimension = 3;
  double bad = nan;
  void rhs(double t, const double* y, double* dydt) const {
    dydt[0] = y[0];
    dydt[1] = t > 1 ? bad : y[1];
    dydt[2] = t > 2 ? bad : y[2];
  }
};

TEST(Guard, RemembersTheFirstNonFiniteValueAndLetsTheRunGoOn) {
  for (const auto& [bad, name] : {std::pair{nan, "nan"}, {inf, "inf"}, {-inf, "-inf"}}) {
    const TurnsBad problem{bad};
    GuardedView guarded(view_of(problem), Budget{});
    const double y[] = {1, 2, 3};
    double dydt[3];
    EXPECT_EQ(guarded.rhs(0.5, y, dydt), 0);
    EXPECT_EQ(guarded.guard().first_non_finite(), "");
    EXPECT_EQ(guarded.rhs(1.25, y, dydt), 0) << "the step may still be rejected";
    EXPECT_EQ(guarded.rhs(3, y, dydt), 0);
    EXPECT_FALSE(guarded.guard().tripped());
    EXPECT_EQ(guarded.guard().first_non_finite(),
              std::string("right-hand side component 1 is ") + name + " at t = 1.25");
    EXPECT_EQ(guarded.guard().rhs_evaluations(), 3U);
  }
}

TEST(Guard, LargeFiniteValuesAreNotNonFinite) {
  Guard guard(2, Budget{});
  const double values[] = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  EXPECT_TRUE(guard.inspect(0, values, 2));
  EXPECT_EQ(guard.first_non_finite(), "");
}

TEST(Guard, GuardedProblemReadsZeroOnceTheBudgetIsSpent) {
  const TurnsBad problem;
  Guard guard(3, Budget{.evaluations = 1});
  const Guarded<TurnsBad> guarded(problem, guard);
  const double y[] = {1, 2, 3};
  double dydt[3] = {};
  guarded.rhs(0, y, dydt);
  EXPECT_FALSE(guarded.tripped());
  EXPECT_EQ(dydt[2], 3);
  guarded.rhs(0, y, dydt);
  EXPECT_TRUE(guarded.tripped());
  for (const double d : dydt) EXPECT_EQ(d, 0);
}

/// y' = y by its Taylor series, as q'' = q, and with a split that needs three products.
struct Exponential {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = true;
  void rhs(double, const double* y, double* f) const { f[0] = y[0], f[1] = y[1]; }
  void jacobian(double, const double*, double* j) const { j[0] = j[3] = 1, j[1] = j[2] = 0; }
  void taylor(double, const double* y, int order, double* c) const {
    for (int k = 1; k <= order; ++k)
      for (int i = 0; i < 2; ++i) c[2 * k + i] = (k == 1 ? y[i] : c[2 * k - 2 + i]) / k;
  }
  void acceleration(double, const double* q, const double*, double* a) const { a[0] = q[0]; }
  std::uint64_t damp(double, const double*, double, double*, double) const { return 3; }
};

TEST(Guard, ACapabilityCostsWhatItsEntrySays) {
  const Exponential problem;
  for (const bool watched : {true, false}) {
    Guard guard(2, Budget{.evaluations = 9, .watched = watched});
    const Guarded<Exponential> guarded(problem, guard);
    double y[] = {1, 2}, out[8] = {7, 7, 7, 7, 7, 7, 7, 7};
    EXPECT_EQ(guarded.taylor(0.0, y, 3, out), 0);
    EXPECT_EQ(out[7], 2.0 / 6);
    EXPECT_EQ(guard.rhs_evaluations(), watched ? 3U : 0U);
    EXPECT_EQ(guarded.acceleration(0.0, y, y + 1, out), 0);
    EXPECT_EQ(guard.rhs_evaluations(), watched ? 4U : 0U);
    guarded.jacobian(0.0, y, out);
    EXPECT_EQ(guard.jacobian_evaluations(), 1U);
    EXPECT_EQ(guarded.damp(0.0, y, 0.1, y + 1, 1e-9), 3U);
    // Four evaluations and three products are spent: the third coefficient is one too many.
    EXPECT_EQ(guarded.taylor(0.0, y, 3, out), watched ? 1 : 0);
    EXPECT_EQ(guarded.tripped(), watched);
    EXPECT_EQ(out[0], 1);
    EXPECT_EQ(out[2], watched ? 0 : 1);
  }
}

TEST(Guard, AllowsAsManyEvaluationsAsTheBudgetAndNoMore) {
  Guard guard(1, Budget{.evaluations = 3});
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(guard.admit()) << i;
  EXPECT_FALSE(guard.tripped()) << "a solve that needs exactly the budget is within it";
  EXPECT_FALSE(guard.admit());
  EXPECT_TRUE(guard.tripped());
  Outcome outcome;
  guard.conclude(fixed_request(1, {1}), outcome);
  EXPECT_EQ(outcome.status, Status::over_budget);
  EXPECT_NE(outcome.detail.find("3 evaluations"), std::string::npos) << outcome.detail;
  EXPECT_EQ(guard.rhs_evaluations(), 3U);
}

TEST(Guard, KeepsTheTimeLimit) {
  Guard guard(1, Budget{.evaluations = 1'000'000, .seconds = 1e-3});
  std::this_thread::sleep_for(std::chrono::milliseconds(3));
  int admitted = 0;
  while (admitted < 10'000 && guard.admit()) ++admitted;
  EXPECT_LT(admitted, 2048) << "the clock is read once in 1024 evaluations";
  Outcome outcome;
  guard.conclude(fixed_request(1, {1}), outcome);
  EXPECT_EQ(outcome.status, Status::over_budget);
  EXPECT_NE(outcome.detail.find("0.001 s"), std::string::npos) << outcome.detail;
}

// Between a few evaluations implicit steps of a large system solve for tens of milliseconds.
TEST(Guard, LooksAtTheClockOftenOnLargeSystems) {
  Guard guard(1000, Budget{.evaluations = 1'000'000, .seconds = 1e-3});
  std::this_thread::sleep_for(std::chrono::milliseconds(3));
  int admitted = 0;
  while (admitted < 10'000 && guard.admit()) ++admitted;
  EXPECT_LT(admitted, 32);
}

/// A library's report after two stops of a problem of two components.
Outcome claim(std::vector<double> states, double t) {
  Outcome outcome;
  outcome.t = t;
  outcome.states = std::move(states);
  return outcome;
}

TEST(Guard, ConcludeBelievesOnlyAFiniteStateAtTheEnd) {
  const Request request = fixed_request(4, {1, 2});
  const Guard guard(2, Budget{});
  Outcome good = claim({1, 2, 3, 4}, 2);
  guard.conclude(request, good);
  EXPECT_EQ(good.status, Status::ok);
  EXPECT_EQ(good.detail, "");

  Outcome with_nan = claim({1, 2, 3, nan}, 2);
  guard.conclude(request, with_nan);
  EXPECT_EQ(with_nan.status, Status::non_finite);
  EXPECT_NE(with_nan.detail.find("component 1"), std::string::npos) << with_nan.detail;

  for (Outcome early : {claim({1, 2}, 2), claim({1, 2, 3, 4}, 1.999), claim({1, 2, 3, 4}, nan),
                        claim({1, 2, 3, 4, 5, 6}, 2), claim({}, 2)}) {
    guard.conclude(request, early);
    EXPECT_EQ(early.status, Status::refused);
    EXPECT_NE(early.detail, "");
  }
}

TEST(Guard, ConcludeKeepsAFailureAndAddsTheFirstNonFiniteValue) {
  const Request request = fixed_request(4, {1, 2});
  Guard guard(2, Budget{.evaluations = 1});
  const double bad[] = {1, inf};
  EXPECT_FALSE(guard.inspect(0.75, bad, 2));
  const std::string first =
      "; first non-finite value: right-hand side component 1 is inf at t = 0.75";
  Outcome good = claim({1, 2, 3, 4}, 2);
  guard.conclude(request, good);
  EXPECT_EQ(good.status, Status::ok) << "the value was in a step that was repeated";
  EXPECT_EQ(good.detail, "");
  Outcome failed = claim({}, 0.5);
  failed.status = Status::newton_failed;
  failed.detail = "why";
  guard.conclude(request, failed);
  EXPECT_EQ(failed.status, Status::newton_failed);
  EXPECT_EQ(failed.detail, "why" + first);
  EXPECT_TRUE(guard.admit());
  EXPECT_FALSE(guard.admit());
  for (const Status claimed : {Status::ok, Status::newton_failed, Status::step_too_small}) {
    Outcome outcome = claim({1, 2, 3, 4}, 2);
    outcome.status = claimed;
    guard.conclude(request, outcome);
    EXPECT_EQ(outcome.status, Status::over_budget) << "outranks the solver";
    EXPECT_NE(outcome.detail.find("1 evaluation"), std::string::npos) << outcome.detail;
  }
}

TEST(FixedGrid, EndsExactlyAtTheHorizonAndKnowsItsStops) {
  const Request request = fixed_request(30, {0.1, 0.2, 0.3});  // 30 * (0.3 / 30) is not 0.3
  const FixedGrid grid(0, request);
  EXPECT_TRUE(grid.fits());
  EXPECT_EQ(grid.t(30), 0.3);
  EXPECT_EQ(grid.index_of(0), 10U);
  EXPECT_EQ(grid.index_of(1), 20U);
  EXPECT_EQ(grid.index_of(2), 30U);
  for (std::uint64_t i = 0; i < 30; ++i)  // i h, with no sum that grows: two roundings
    EXPECT_NEAR(grid.t(i), 0.01 * static_cast<double>(i), 1e-16);
  const Request shifted = fixed_request(4, {2, 3});
  EXPECT_EQ(FixedGrid(1, shifted).t(2), 2);
  EXPECT_EQ(FixedGrid(1, shifted).index_of(0), 2U);
}

TEST(FixedGrid, KnowsWhichStopsDoNotFit) {
  EXPECT_FALSE(FixedGrid(0, fixed_request(3, {0.5, 1})).fits());
  EXPECT_FALSE(FixedGrid(0, fixed_request(2, {1e-9, 1})).fits()) << "a stop before the first step";
  EXPECT_TRUE(FixedGrid(0, fixed_request(1'000'000'000, {0.35, 0.7})).fits());
}

TEST(Requests, OffTheGridAreRefusedAndMalformedOnesThrow) {
  const Case& c = find_case("free_fall");
  const Entrant& rk4 = find_entrant(c, "odeum/rk4");
  const Outcome off = rk4.solve(fixed_request(3, {0.5, 1}));
  EXPECT_EQ(off.status, Status::refused);
  EXPECT_NE(off.detail.find("grid"), std::string::npos) << off.detail;
  EXPECT_TRUE(off.states.empty());
  for (const Entrant& entrant : c.entrants) {
    if (!entrant.solve) continue;
    SCOPED_TRACE(entrant.info.id());
    EXPECT_THROW(entrant.solve(fixed_request(4, {})), std::invalid_argument);
    EXPECT_THROW(entrant.solve(fixed_request(0, {1})), std::invalid_argument);
    for (const std::vector<double>& stops :
         std::vector<std::vector<double>>{{0}, {-1}, {1, 1}, {2, 1}, {nan}, {inf}, {1, nan, 2}})
      EXPECT_THROW(entrant.solve(fixed_request(4, stops)), std::invalid_argument);
    for (const double tolerance : {0.0, -1e-6, nan, inf})
      EXPECT_THROW(entrant.solve(adaptive_request(tolerance, {1})), std::invalid_argument);
  }
}

}  // namespace
}  // namespace odeum::tests::guard_test
