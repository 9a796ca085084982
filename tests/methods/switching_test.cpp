// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "support/catalogue.hpp"

namespace odeum {
namespace {

using tests::find_case;
using tests::find_entrant;

struct Made {
  std::uint64_t evaluations, jacobians;
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
  return {outcome.counters.rhs_evaluations, outcome.counters.jacobian_evaluations, error};
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

}  // namespace
}  // namespace odeum
