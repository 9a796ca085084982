// SPDX-License-Identifier: BSD-3-Clause
// The texts with events among the shipped problems, against references of 30 digits
// (cases/problems/hybrid.py).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>

#include "odeum/cases/reference.hpp"
#include "support/hybrid_text.hpp"

namespace odeum::hybrid_problems_test {
namespace {

const std::string folder = ODEUM_SOURCE_DIR "/cases/problems/";

tests::HybridText text_of(const std::string& name) {
  return tests::HybridText(formula::problem_text(folder + name + ".yaml"));
}

struct Expected {
  const char* name;
  std::size_t events;  ///< that happen up to the end
  friend std::ostream& operator<<(std::ostream& out, const Expected& x) { return out << x.name; }
};

class HybridProblem : public testing::TestWithParam<Expected> {};

TEST_P(HybridProblem, IsSolvedByEachFamilyWithAllItsEvents) {
  const tests::HybridText text = text_of(GetParam().name);
  const std::size_t n = text.problem.y0.size();
  std::vector<double> exact(n);
  ASSERT_TRUE(cases::reference_truth(GetParam().name, 1e-13, folder)
                  .at(text.problem.stops.back(), exact.data()));
  for (const char* const id :
       {"odeum/dormand_prince54", "odeum/rodas4", "odeum/bdf_variable", "cvode/bdf", "gsl/rkf45"}) {
    if (!cases::enroll(text.contest).find(id)) continue;  // a library that is not built
    const Outcome outcome = text.run(id, 1e-9);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    EXPECT_EQ(outcome.events.size(), GetParam().events) << id;
    // The variable orders leave up to a thousand tolerances after dozens of events.
    for (std::size_t i = 0; i < n; ++i)
      EXPECT_NEAR(outcome.states[outcome.states.size() - n + i], exact[i], 1e-6) << id << ", " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Problems, HybridProblem,
                         testing::Values(Expected{"bouncing_ball", 6}, Expected{"thermostat", 29},
                                         Expected{"relay", 25}, Expected{"impact_oscillator", 10},
                                         Expected{"stick_slip", 4}, Expected{"doses", 5}),
                         [](const auto& info) { return std::string(info.param.name); });

// At t = 5 the mass slips, where step 400 of 2,000 ends: what is left of the way to the event is
// some roundings of the time, a step that ARKODE does not make.
TEST(HybridProblems, AnEventJustBehindAStepIsFoundThere) {
  const tests::HybridText text = text_of("stick_slip");
  for (const char* const id :
       {"arkode/erkstep_cash_karp_6_4_5", "arkode/erkstep_dormand_prince_7_4_5", "gsl/rkck",
        "odeum/cash_karp54"}) {
    if (!cases::enroll(text.contest).find(id)) continue;
    const Outcome outcome = text.run_fixed(id, 2000);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    ASSERT_FALSE(outcome.events.empty()) << id;
    EXPECT_NEAR(outcome.events.front().t, 5, 1e-12) << id;
  }
}

}  // namespace
}  // namespace odeum::hybrid_problems_test
