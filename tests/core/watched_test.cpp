// SPDX-License-Identifier: BSD-3-Clause
// A timed run (not watched) ends as the counted run (watched) did.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support/catalogue.hpp"

namespace odeum::tests::watched_test {
namespace {

bool is_own(const Entrant& entrant) { return entrant.info.library == "odeum" && entrant.solve; }

/// Evaluations: the slow runs are left out, the rest takes seconds.
constexpr std::uint64_t budget = 20'000;

void expect_the_same_end(const Entrant& entrant, Request request, std::uint64_t evaluations) {
  request.budget.evaluations = evaluations;
  const Outcome watched = entrant.solve(request);
  if (watched.status == Status::over_budget) return;  // a timed run has no bound
  request.budget.watched = false;
  const Outcome timed = entrant.solve(request);
  EXPECT_EQ(timed.status, watched.status) << to_string(timed.status) << ", watched "
                                          << to_string(watched.status) << ' ' << watched.detail;
  // Without the guard a failing run may notice it later, and have recorded more states.
  if (watched.status == Status::ok) {
    EXPECT_EQ(timed.states, watched.states);
  }
}

TEST(Watched, TimedRunsEndAlike) {
  int checked = 0;
  for (const char* id : {"vdp_eps1e_6", "vdp_mu1", "fput_alpha", "robertson_40", "kepler_e09",
                         "arenstorf", "hires", "lorenz_kehlet_logg"}) {
    const Case& c = find_case(id);
    for (const Entrant& entrant : c.entrants) {
      if (!is_own(entrant)) continue;
      SCOPED_TRACE(entrant.info.id() + " on " + id);
      if (entrant.info.adaptive)
        for (const double tolerance : {1e-2, 1e-4, 1e-6})
          expect_the_same_end(entrant, adaptive_request(tolerance, c.stops), budget);
      if (entrant.info.fixed)
        for (const std::uint64_t factor : {1, 8})
          expect_the_same_end(entrant, fixed_request(factor * c.settings.coarsest_steps, c.stops),
                              budget);
      ++checked;
    }
  }
  EXPECT_GE(checked, 8 * 30);
}

// Peers too, on all cases of few unknowns.
TEST(Watched, RunsOfAllSolversOnAllCasesEndAlike) {
  std::size_t checked = 0;
  for (const Case& c : all_cases()) {
    if (c.y0.size() > 64) continue;
    for (const Entrant& entrant : c.entrants) {
      if (!entrant.solve) continue;
      SCOPED_TRACE(entrant.info.id() + " on " + c.id);
      if (entrant.info.adaptive)
        expect_the_same_end(entrant, adaptive_request(1e-4, c.stops), 4000);
      if (entrant.info.fixed && c.settings.no_fixed_steps.empty())
        expect_the_same_end(entrant, fixed_request(c.settings.coarsest_steps, c.stops), 4000);
      ++checked;
    }
  }
  EXPECT_GE(checked, all_cases().size() * 50);
}

/// Runs that meet values which are not finite, in steps that they repeat.
TEST(Watched, ARepeatedStepFailsNoRun) {
  struct Run {
    const char *solver, *id;
    double tolerance;
  };
  for (const Run& run : {Run{"odeum/gauss6", "vdp_eps1e_6", 1e-2},
                         {"odeum/gauss6", "vdp_mu1000", 1e-6},
                         {"odeum/lobatto_iiic4", "vdp_eps1e_6", 1e-4},
                         {"odeum/lobatto_iiic4", "vdp_mu1000", 1e-5},
                         {"odeum/radau_iia3", "vdp_eps1e_6", 1e-3},
                         {"odeum/radau_iia3", "vdp_mu1000", 1e-4},
                         {"odeum/blanes_moan6", "fput_beta", 1e-3}}) {
    SCOPED_TRACE(fmt::format("{} on {} to {}", run.solver, run.id, run.tolerance));
    const Case& c = find_case(run.id);
    Request request = adaptive_request(run.tolerance, c.stops);
    request.budget.evaluations = 200'000;
    const Outcome outcome = find_entrant(c, run.solver).solve(request);
    EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
  }
}

}  // namespace
}  // namespace odeum::tests::watched_test
