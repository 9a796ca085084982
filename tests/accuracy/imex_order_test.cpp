// SPDX-License-Identifier: BSD-3-Clause
// Additive methods on the built-in cases that say which of their terms are implicit.
#include <gtest/gtest.h>

#include <algorithm>

#include "odeum/cases/catalogue.hpp"
#include "odeum/solvers/entrants.hpp"
#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::imex_order_test {
namespace {

const std::vector<std::string> own{"odeum/ars222", "odeum/ars443", "odeum/ark32_kennedy_carpenter",
                                   "odeum/ark43_kennedy_carpenter"};

TEST(ImexOrder, IsConfirmedOnCasesThatSayTheirParts) {
  for (const char* const mode : {"fixed", "adaptive"})
    for (const std::string& solver : own) {
      const study::ConvergenceResult result = study::converge(
          {.cases = {"brusselator2", "vdp_mu1"}, .solvers = {solver}, .own = {{"mode", mode}}});
      ASSERT_EQ(result.orders.size(), 2U) << solver;
      for (const auto& order : result.orders) {
        EXPECT_EQ(order.fit.verdict, judge::Verdict::confirmed)
            << solver << ' ' << mode << ": " << to_string(order.fit.verdict) << ' '
            << order.fit.order << ' ' << order.fit.reason;
      }
    }
}

TEST(ImexOrder, FitsNoProblemThatDoesNot) {
  const Entrants& entrants = known_case("lotka_volterra").entrants;
  for (const std::string& solver : own) {
    ASSERT_TRUE(entrants.find(solver)) << solver;
    EXPECT_NE(entrants.find(solver)->unfit.find("split into an explicit and an implicit part"),
              std::string::npos)
        << entrants.find(solver)->unfit;
  }
}

// The stiff part bounds no step: 25,000 times 1/lambda. Of its order h^2 is left, the order of the
// stages.
TEST(ImexOrder, AStiffImplicitPartBoundsNoStep) {
  const Case& c = known_case("prothero_robinson_1e6_smooth");
  Request request{.steps = 400, .stops = c.stops};
  for (const std::string& solver : own) {
    const Outcome outcome = c.entrants.find(solver)->solve(request);
    ASSERT_EQ(outcome.status, Status::ok) << solver << ": " << outcome.detail;
    EXPECT_NEAR(outcome.states.back(), std::cos(c.stops.back()), 1e-3) << solver;
  }
}

}  // namespace
}  // namespace odeum::imex_order_test
