// SPDX-License-Identifier: BSD-3-Clause
// Random pairs of runs of own methods and peers, without outputs and with some: an output breaks no
// run and changes none. ODEUM_PAIRS=4000 makes so many of them, in some minutes:
//   ODEUM_PAIRS=4000 build/release/tests/odeum_unit_tests --gtest_filter=RandomOutputs.*
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "odeum/trajectories/case_runs.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::random_outputs_test {
namespace {

constexpr std::array cases{
    "lotka_volterra", "brusselator2", "robertson_40",   "hires",
    "vdp_mu1",        "vdp_mu1000",   "vdp_eps1e_6",    "henon_heiles_regular",
    "pendulum_large", "kepler_e06",   "arenstorf",      "medakzo",
    "duffing_free",   "rc_circuit",   "rigid_body_hlw", "brusselator_1d"};

/// Whether outputs leave the steps as they are, so that the run itself can be compared: its library
/// interpolates. Steps of the others end on outputs.
bool interpolates(const SolverInfo& info) {
  const std::string id = info.id();
  return info.library == "odeum" || info.library == "cvode" ||
         (info.library == "arkode" && info.family == "explicit_rk") ||
         id == "odeint/runge_kutta_dopri5" || id == "odeint/rosenbrock4" ||
         id.find("dense_out") != std::string::npos;
}

TEST(RandomOutputs, BreakNoRunAndChangeNone) {
  const char* const asked = std::getenv("ODEUM_PAIRS");
  const int pairs = asked ? std::atoi(asked) : 150;
  std::uint64_t state = 29;
  const auto random = [&](std::size_t below) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>(state >> 33) % below;
  };
  int compared = 0, broken = 0, by_own_runs = 0;
  std::map<std::string, int> of_library;
  for (int k = 0; compared < pairs && k < 40 * pairs; ++k) {
    const Case& c = find_case(cases.at(random(cases.size())));
    const Entrant& entrant = c.entrants[random(c.entrants.size())];
    const double tolerance = std::pow(10, -1 - static_cast<double>(random(70)) / 10);
    const std::size_t outputs = 2 + random(60);
    if (!entrant.unfit.empty() || !entrant.info.adaptive) continue;
    Request without = adaptive_request(tolerance, {c.stops.back()});
    without.budget.evaluations = 5000;  // what does not suit the case is left out
    const Outcome alone = entrant.solve(without);
    if (alone.status != Status::ok) continue;
    Request with = without;
    with.over_stops = true;
    with.budget = {};
    with.stops.clear();
    for (std::size_t j = 1; j <= outputs; ++j)
      with.stops.push_back(c.t0 + (c.stops.back() - c.t0) * static_cast<double>(j) /
                                      static_cast<double>(outputs));
    with.stops.back() = c.stops.back();
    const std::string what =
        fmt::format("{} by {} to {:.2e}, {} outputs", c.id, entrant.info.id(), tolerance, outputs);
    const Outcome shown = trajectories::solve_with_outputs(entrant, with);
    ++compared;
    ++of_library[entrant.info.library];
    broken += shown.status != Status::ok;
    EXPECT_EQ(shown.status, Status::ok) << what << ": " << shown.detail;
    if (shown.status != Status::ok) continue;
    const std::size_t n = c.y0.size();
    ASSERT_EQ(shown.states.size(), n * outputs) << what;
    const auto same_end = [&](const Outcome& outcome) {
      const auto end = state_at(outcome, outputs - 1, n);
      return std::equal(end.begin(), end.end(), alone.states.begin());
    };
    EXPECT_TRUE(same_end(shown)) << what;
    const bool by_own_run = shown.detail.find("that of a run of its own") != std::string::npos;
    by_own_runs += by_own_run;
    EXPECT_TRUE(by_own_run || is_finite(shown.states.data(), shown.states.size())) << what;
    const bool marked = by_own_run || shown.detail.find("is interpolated") != std::string::npos;
    EXPECT_TRUE(marked || shown.detail == alone.detail) << what << ": " << shown.detail;
    EXPECT_EQ(shown.counters.steps, alone.counters.steps) << what;
    EXPECT_EQ(shown.counters.rhs_evaluations, alone.counters.rhs_evaluations) << what;
    EXPECT_EQ(shown.counters.jacobian_evaluations, alone.counters.jacobian_evaluations) << what;
    if (!interpolates(entrant.info)) continue;
    const Outcome raw = entrant.solve(with);
    EXPECT_TRUE(same_end(raw)) << what << ": its steps change";
    EXPECT_EQ(raw.counters.steps, alone.counters.steps) << what;
  }
  std::string counts = fmt::format(
      "{} pairs, {} broken, {} with outputs by runs of their own:", compared, broken, by_own_runs);
  for (const auto& [library, count] : of_library) counts += fmt::format(" {} {}", library, count);
  fmt::print("{}\n", counts);
  EXPECT_EQ(compared, pairs);
}

// Steps of ARKODE's implicit tables end on outputs, and here do so at the rounding of t: the run
// ended with 3, without outputs with 0.
TEST(RandomOutputs, WhereStepsCannotEndAreThoseOfRunsOfTheirOwn) {
  const Case& c = find_case("robertson_40");
  const Entrant& entrant = find_entrant(c, "arkode/arkstep_ark548l2sab_dirk_8_4_5");
  int found = 0;
  for (int k = 0; k < 40; ++k) {
    const std::size_t outputs = 20 + static_cast<std::size_t>(k);
    Request request = adaptive_request(1.58e-2, {});
    request.over_stops = true;
    for (std::size_t j = 1; j <= outputs; ++j)
      request.stops.push_back(40 * static_cast<double>(j) / static_cast<double>(outputs));
    const Outcome raw = entrant.solve(request);
    const Outcome shown = trajectories::solve_with_outputs(entrant, request);
    ASSERT_EQ(shown.status, Status::ok) << shown.detail;
    ASSERT_EQ(shown.states.size(), 3 * outputs);
    EXPECT_TRUE(is_finite(state_at(shown, outputs - 1, 3).data(), 3)) << outputs;
    if (raw.status == Status::ok) continue;
    ++found;
    EXPECT_NE(shown.detail.find("that of a run of its own"), std::string::npos) << shown.detail;
  }
  EXPECT_GT(found, 0) << "none of these fails any more: another case is needed";
}

}  // namespace
}  // namespace odeum::tests::random_outputs_test
