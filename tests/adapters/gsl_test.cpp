// SPDX-License-Identifier: BSD-3-Clause
#include "gsl/solvers.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <thread>

#include "adapters/peer_stage.hpp"
#include "support/enrolled.hpp"

namespace odeum::test::gsl_test {
namespace {

std::vector<Entrant> enrolled(Circle problem) {
  return tests::enrolled_on(erase(circle(problem)), adapters::gsl::add_solvers);
}

TEST(Gsl, HasElevenSteppers) { EXPECT_EQ(enrolled({}).size(), 11u); }

TEST(Gsl, EachStepperIsHonest) {
  for (const Entrant& entrant : enrolled({})) expect_honest(entrant, enrolled);
}

TEST(Gsl, ErrorFallsWithTolerance) {
  for (const Entrant& entrant : enrolled({})) {
    // Orders 12 and 8 are more accurate than any tolerance here, which is what is tested.
    if (entrant.info.method == "bsimp" || entrant.info.method == "rk8pd") {
      EXPECT_LT(circle_error(entrant.solve(adaptive_request(1e-7))), 1e-7);
    } else {
      expect_converges_with_tolerance(entrant);
    }
  }
}

TEST(Gsl, AFastStartIsNoObstacleToALongHorizon) {
  const std::vector<Entrant> entrants =
      tests::enrolled_on(erase(contest_of(Approach{}, {2})), adapters::gsl::add_solvers);
  expect_long_horizon(entrants, {"msbdf", "bsimp", "rk4imp"});
}

struct Expected {
  const char* method;
  double order;
  std::uint64_t coarsest;
};

/// Slopes at errors of 1e-4 to 1e-11 are within 0.4 of the order here: the next term of the error
/// is smaller by h times a constant of the problem's size.
TEST(Gsl, OrdersAtAFixedStep) {
  // rk2 claims 2; see reports/findings/gsl.md.
  const Expected table[] = {{"rk2", 3, 16},    {"rk4", 4, 16},    {"rkf45", 5, 16}, {"rkck", 5, 16},
                            {"rk1imp", 1, 64}, {"rk2imp", 2, 16}, {"rk4imp", 4, 16}};
  const std::vector<Entrant> entrants = enrolled({});
  for (const Expected& expected : table)
    EXPECT_NEAR(circle_order(find(entrants, expected.method), expected.coarsest), expected.order,
                0.4)
        << expected.method;
}

/// Order 8 is above rounding for few steps only: 16 at most, whose rounding is some 1e-15.
TEST(Gsl, OrderOfRk8pd) {
  EXPECT_NEAR(circle_order(find(enrolled({}), "rk8pd"), 4, 3e-14), 8, 0.7);
}

TEST(Gsl, ClaimsWhatTheLibraryClaims) {
  const std::vector<Entrant> entrants = enrolled({});
  EXPECT_EQ(find(entrants, "rk2").info.order, 2);
  EXPECT_TRUE(std::isnan(find(entrants, "msadams").info.order));
  EXPECT_GT(find(entrants, "bsimp").info.order, 2);  // asked of the library, even
}

TEST(Gsl, DenseMatricesHaveALimit) {
  const std::vector<Entrant> entrants = tests::enrolled_on(
      erase(contest_of(Wide{}, std::vector<double>(Wide{}.size(), 1))), adapters::gsl::add_solvers);
  EXPECT_EQ(find(entrants, "rk4imp").solve(fixed_request(8)).status, Status::over_budget);
  EXPECT_EQ(find(entrants, "rk4").solve(fixed_request(8)).status, Status::ok);
}

/// No unknowns: the library's answer to a vector of length 0 is its error handler, which aborts.
struct Nothing {
  static constexpr std::size_t dimension = dynamic;
  std::size_t size() const { return 0; }
  void rhs(double, const double*, double*) const {}
};

TEST(Gsl, NoUnknownsAreRefused) {
  const std::vector<Entrant> entrants =
      tests::enrolled_on(erase(contest_of(Nothing{}, {})), adapters::gsl::add_solvers);
  for (const Entrant& entrant : entrants)
    EXPECT_EQ(entrant.solve(adaptive_request(1e-6)).status, Status::refused) << entrant.info.method;
}

struct Decay {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* dydt) const { dydt[0] = -y[0] * y[0]; }
};

TEST(Gsl, AProblemWithoutJacobianIsDifferenced) {
  const std::vector<Entrant> entrants =
      tests::enrolled_on(erase(contest_of(Decay{}, {1})), adapters::gsl::add_solvers);
  const Outcome outcome = find(entrants, "rk4imp").solve(fixed_request(64));
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  // y = 1 / (1 + t); order 4 with h = 1/32 leaves about h^4.
  EXPECT_NEAR(outcome.states.back(), 1.0 / 3, 1e-7);
}

TEST(Gsl, TwoThreadsAgreeWithOne) {
  const std::vector<Entrant> entrants = enrolled({});
  for (const char* method : {"rk8pd", "rk4imp", "bsimp"}) {
    const Entrant& entrant = find(entrants, method);
    const Outcome alone = entrant.solve(fixed_request(64));
    Outcome first, second;
    std::thread thread([&] { first = entrant.solve(fixed_request(64)); });
    second = entrant.solve(fixed_request(64));
    thread.join();
    EXPECT_EQ(first.states, alone.states) << method;
    EXPECT_EQ(second.states, alone.states) << method;
  }
}

}  // namespace
}  // namespace odeum::test::gsl_test
