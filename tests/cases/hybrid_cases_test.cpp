// SPDX-License-Identifier: BSD-3-Clause
// The cases with events, against references of 30 digits (cases/reference/hybrid.py).
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "odeum/judge/errors.hpp"
#include "support/catalogue.hpp"

namespace odeum::hybrid_cases_test {
namespace {

struct Expected {
  const char* name;
  std::size_t events;  ///< that happen up to the end
  friend std::ostream& operator<<(std::ostream& out, const Expected& x) { return out << x.name; }
};

class HybridCase : public testing::TestWithParam<Expected> {};

TEST_P(HybridCase, IsSolvedByEachFamilyWithAllItsEvents) {
  const Case& c = tests::find_case(GetParam().name);
  ASSERT_TRUE(c.problem.events);
  const Request request = tests::adaptive_request(1e-9, c.stops);
  for (const char* const id :
       {"odeum/dormand_prince54", "odeum/rodas4", "odeum/bdf_variable", "cvode/bdf", "gsl/rkf45"}) {
    const Entrant* const entrant = c.entrants.find(id);
    if (!entrant) continue;  // a library that is not built
    const Outcome outcome = entrant->solve(request);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    EXPECT_EQ(outcome.events.size(), GetParam().events) << id;
    // The variable orders leave up to a thousand tolerances after dozens of events.
    const double error = judge::error_at(
        c, c.stops.back(), outcome.states.data() + outcome.states.size() - c.y0.size());
    EXPECT_LE(error, 1e-6) << id;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, HybridCase,
                         testing::Values(Expected{"bouncing_ball", 6}, Expected{"thermostat", 29},
                                         Expected{"relay", 25}, Expected{"impact_oscillator", 10},
                                         Expected{"stick_slip", 4}, Expected{"doses", 5}),
                         [](const auto& info) { return std::string(info.param.name); });

// At t = 5 the mass slips, where step 400 of 2,000 ends: what is left of the way to the event is
// some roundings of the time, a step that ARKODE does not make.
TEST(HybridCases, AnEventJustBehindAStepIsFoundThere) {
  const Case& c = tests::find_case("stick_slip");
  for (const char* const id :
       {"arkode/erkstep_cash_karp_6_4_5", "arkode/erkstep_dormand_prince_7_4_5", "gsl/rkck",
        "odeum/cash_karp54"}) {
    const Entrant* const entrant = c.entrants.find(id);
    if (!entrant) continue;
    const Outcome outcome = entrant->solve(tests::fixed_request(2000, c.stops));
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    ASSERT_FALSE(outcome.events.empty()) << id;
    EXPECT_NEAR(outcome.events.front().t, 5, 1e-12) << id;
  }
}

}  // namespace
}  // namespace odeum::hybrid_cases_test
