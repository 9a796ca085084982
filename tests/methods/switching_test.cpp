// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/catalogue.hpp"

namespace odeum::switching_test {
namespace {

using tests::find_case;
using tests::find_entrant;

struct Made {
  std::uint64_t evaluations, jacobians, steps;
  double error;
};

Made run(const std::string& id, const std::string& solver, double tolerance) {
  const Case& c = find_case(id);
  // With the thresholds of the case: an explicit pair at its stability bound leaves noise of the
  // size of the tolerance, and Robertson's y2, of 4e-5, may not become negative.
  Request request = tests::adaptive_request(tolerance, {c.stops.back()});
  set_tolerance(request, c, tolerance);
  const Outcome outcome = find_entrant(c, "odeum/" + solver).solve(request);
  EXPECT_EQ(outcome.status, Status::ok) << id << " " << solver << ": " << outcome.detail;
  std::vector<double> exact(c.y0.size());
  EXPECT_TRUE(c.truth.at(c.stops.back(), exact.data()));
  double error = 0;
  for (std::size_t k = 0; k < exact.size(); ++k)
    error = std::fmax(error, std::abs(outcome.states.at(k) - exact[k]) / c.scale_of(k));
  return {outcome.counters.rhs_evaluations, outcome.counters.jacobian_evaluations,
          outcome.counters.steps, error};
}

// Its looks at the spectral radius, three evaluations each ten steps of sixty, change no step.
TEST(Switching, StaysWithTheExplicitPairWhereTheProblemIsNotStiff) {
  for (const char* id : {"lotka_volterra", "kepler_e06", "vdp_mu1", "henon_heiles_regular"})
    for (const double tolerance : {1e-4, 1e-7}) {
      SCOPED_TRACE(std::string(id) + " to " + std::to_string(tolerance));
      const Made alone = run(id, "dormand_prince54", tolerance),
                 both = run(id, "dormand_prince54_rodas4", tolerance);
      EXPECT_EQ(both.jacobians, 0U);
      EXPECT_LE(static_cast<double>(both.evaluations),
                1.06 * static_cast<double>(alone.evaluations));
      EXPECT_EQ(both.error, alone.error);
    }
}

// Before it takes over, the explicit pair has spent some tens of steps; each way back costs as
// many.
TEST(Switching, TakesTheImplicitPairWhereItIs) {
  for (const char* id : {"robertson_40", "hires", "vdp_mu1000", "oregonator"})
    for (const double tolerance : {1e-4, 1e-7}) {
      SCOPED_TRACE(std::string(id) + " to " + std::to_string(tolerance));
      const Made stiff = run(id, "rodas4", tolerance),
                 both = run(id, "dormand_prince54_rodas4", tolerance);
      EXPECT_GT(both.jacobians, 0U);
      EXPECT_LT(static_cast<double>(both.evaluations),
                1.3 * static_cast<double>(stiff.evaluations) + 250);
      EXPECT_LT(both.jacobians, stiff.jacobians);
    }
}

// With less than 1.35 times the evaluations of the better of two fixed orders, at any tolerance.
TEST(RadauOfVariableOrder, TakesTheOrderThatTheToleranceAsksFor) {
  for (const char* id : {"hires", "robertson", "vdp_mu1000", "oregonator"})
    for (const double tolerance : {1e-4, 1e-7, 1e-11}) {
      SCOPED_TRACE(std::string(id) + " to " + std::to_string(tolerance));
      const Made five = run(id, "radau_iia5", tolerance), nine = run(id, "radau_iia9", tolerance),
                 any = run(id, "radau_iia_variable", tolerance);
      EXPECT_LT(static_cast<double>(any.evaluations),
                1.35 * static_cast<double>(std::min(five.evaluations, nine.evaluations)));
      // The errors of the two differ by as much.
      EXPECT_LT(any.error, 100 * std::max({five.error, nine.error, 1e-15}));
      if (tolerance < 1e-10) {
        EXPECT_LT(any.steps, five.steps / 3);
      }
    }
}

// From the first stop on the order is above 5, and the outputs are those of its own steps.
TEST(RadauOfVariableOrder, HasItsAccuracyBetweenSteps) {
  const Case& c = find_case("vdp_mu1000");
  Request request = tests::adaptive_request(1e-11, c.stops);
  const Outcome with_stops = find_entrant(c, "odeum/radau_iia_variable").solve(request);
  ASSERT_EQ(with_stops.status, Status::ok) << with_stops.detail;
  std::vector<double> exact(c.y0.size());
  for (std::size_t k = 0; k < c.stops.size(); ++k) {
    ASSERT_TRUE(c.truth.at(c.stops[k], exact.data()));
    for (std::size_t i = 0; i < exact.size(); ++i)
      EXPECT_NEAR(with_stops.states[k * exact.size() + i], exact[i], 1e-9 * c.scale_of(i)) << k;
  }
}

}  // namespace
}  // namespace odeum::switching_test
