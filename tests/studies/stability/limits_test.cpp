// SPDX-License-Identifier: BSD-3-Clause
// The whole study: measured limits against the methods' own stability functions and textbooks.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>

#include "odeum/judge/stability_search.hpp"
#include "odeum/kernel/explicit_rk.hpp"
#include "odeum/measure/growth_meter.hpp"
#include "odeum/proof/facts.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/solvers/enroll_method.hpp"
#include "odeum/studies/stability/raster_lanes.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::study::limits_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// A limit is quoted to 1e-6. Measured and theoretical ones are bisected to 1e-10; the rest is
// rounding, largest where an iteration stops converging (1e-16 / 1e-11 / 200 iterations).
constexpr double quoted = 1e-6;

using Key = std::pair<std::string, std::string>;

Options own_limits() {
  Options options;
  options.solvers = {"odeum/*"};
  options.own = {{"grid", "5"}};
  return options;
}

const StabilityResult& own() {
  static const StabilityResult result = measure_stability(own_limits());
  return result;
}

std::map<Key, StabilityLimit> own_by_key() {
  std::map<Key, StabilityLimit> map;
  for (const StabilityLimit& row : own().limits) map[{row.solver, row.axis}] = row;
  return map;
}

TEST(Limits, EveryOwnMethodHasARowOnEveryAxisAndAReasonWhereItDoesNotFit) {
  const auto limits = own_by_key();
  for (const proof::MethodFacts& method : proof::all_method_facts()) {
    for (const char* axis : {"real", "imaginary", "oscillator"}) {
      const auto found = limits.find({std::string(method.info.id), axis});
      ASSERT_NE(found, limits.end()) << method.info.id << ' ' << axis;
      const StabilityLimit& row = found->second;
      if (row.status == "not_applicable") {
        EXPECT_NE(row.detail, "") << method.info.id << ' ' << axis;
        EXPECT_TRUE(std::isnan(row.limit));
      } else {
        // A limit that theory does not give is never silent.
        const bool differs = row.difference > study::limit_tolerance;
        EXPECT_EQ(row.status, differs ? "differs" : "ok")
            << method.info.id << ' ' << axis << ": " << row.detail;
        EXPECT_EQ(differs, row.detail.find("in theory") != std::string::npos) << row.detail;
      }
    }
  }
}

TEST(Limits, OwnOneStepMethodsMeetTheirStabilityFunction) {
  std::size_t compared = 0;
  for (const proof::MethodFacts& method : proof::all_method_facts()) {
    // Multistep methods of one step have no tableau to take a theory from.
    if (!method.info.one_step || method.info.family == "multistep") continue;
    for (const StabilityLimit& row : own().limits) {
      if (row.solver != method.info.id || row.status == "not_applicable") continue;
      // On the imaginary axis |R| exceeds one by c y^6 from 0 on, with a c so small that the growth
      // cannot be told from rounding up to 0.69.
      if (row.solver == "seulex" && row.axis != "real") continue;
      // Squaring amplifies the rounding of e^(hA) by |hA|: growth that the study measures.
      if (row.solver == "exponential_propagator" && row.axis != "real") continue;
      EXPECT_FALSE(std::isnan(row.theory)) << row.solver << " has no theory on " << row.axis;
      EXPECT_LT(row.difference, quoted)
          << row.solver << ' ' << row.axis << ": " << row.limit << " against " << row.theory;
      ++compared;
    }
  }
  EXPECT_GE(compared, proof::all_method_facts().size());
}

TEST(Limits, Textbook) {
  const auto limits = own_by_key();
  const std::map<Key, double> known{
      {{"explicit_euler", "real"}, 2},
      {{"explicit_euler", "imaginary"}, 0},
      {{"explicit_euler", "oscillator"}, 0},
      {{"heun", "real"}, 2},
      {{"heun", "imaginary"}, 0},
      {{"midpoint", "real"}, 2},
      {{"midpoint", "imaginary"}, 0},
      {{"rk4", "real"}, 2.785293563405282},
      {{"rk4", "imaginary"}, 2 * std::sqrt(2.0)},
      {{"rk4", "oscillator"}, 2 * std::sqrt(2.0)},
      {{"implicit_euler", "real"}, infinity},
      {{"implicit_euler", "imaginary"}, infinity},
      {{"implicit_euler", "oscillator"}, infinity},
      {{"implicit_euler_linearised", "real"}, infinity},
      // The iteration contracts by |z| and has 200 times to fall under 1e-11.
      {{"implicit_euler_fixed_point", "real"}, std::pow(1e-11, 1. / 200)},
      {{"implicit_euler_fixed_point", "imaginary"}, std::pow(1e-11, 1. / 200)},
      {{"leapfrog", "oscillator"}, 2},
      {{"stormer_verlet", "oscillator"}, 2},
      {{"velocity_verlet", "oscillator"}, 2},
      {{"symplectic_euler", "oscillator"}, 2},
      {{"symplectic_euler_position_first", "oscillator"}, 2},
  };
  for (const auto& [key, value] : known) {
    const auto found = limits.find(key);
    ASSERT_NE(found, limits.end()) << key.first;
    if (std::isinf(value))
      EXPECT_EQ(found->second.limit, value) << key.first << ' ' << key.second;
    else
      EXPECT_NEAR(found->second.limit, value, quoted) << key.first << ' ' << key.second;
  }
}

TEST(Regions, GrowthIsTheStabilityFunction) {
  Options options;
  options.solvers = {"odeum/rk4", "odeum/implicit_euler"};
  options.own = {{"plane", "lambda"}, {"grid", "13"}};  // every whole number of the window
  for (const StabilityRegion& region : measure_stability(options).regions) {
    ASSERT_EQ(region.growth.size(), 13U * 13U);
    for (int j = 0; j < 13; ++j)
      for (int i = 0; i < 13; ++i) {
        const std::complex<double> z(-8 + i, -6 + j);
        const auto r = region.solver == "rk4"
                           ? 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))
                           : 1.0 / (1.0 - z);
        const float growth =
            region.growth[13 * static_cast<std::size_t>(j) + static_cast<std::size_t>(i)];
        if (z == 1.0 && region.solver == "implicit_euler")
          EXPECT_TRUE(std::isnan(growth));  // the pole: no solution to the step's equation
        else
          EXPECT_NEAR(growth / std::abs(r), 1, 1e-6) << region.solver << z;  // floats: 6e-8
      }
  }
}

TEST(Regions, OscillatorPlane) {
  Options options;
  options.solvers = {"odeum/symplectic_euler"};
  options.own = {{"plane", "oscillator"}, {"grid", "9"}};
  const StabilityResult result = measure_stability(options);
  ASSERT_EQ(result.regions.size(), 1U);
  ASSERT_EQ(result.regions[0].growth.size(), 9U * 5U);
  for (int j = 0; j < 5; ++j)
    for (int i = 1; i < 9; ++i) {
      // v' = v - 2 zeta w v - w^2 q, q' = q + v': trace and determinant of the map.
      const double w = 0.5 * i, zeta = 0.5 * j, det = 1 - 2 * zeta * w;
      const double half = (1 + det - w * w) / 2, disc = half * half - det;
      const double radius = disc < 0 ? std::sqrt(det) : std::abs(half) + std::sqrt(disc);
      // A double root (disc = 0) is known to the root of rounding only.
      EXPECT_NEAR(result.regions[0].growth[static_cast<std::size_t>(9 * j + i)], radius,
                  1e-4 * std::max(1.0, radius))
          << "w " << w << " zeta " << zeta;
    }
}

TEST(Stability, DoesNotDependOnTheNumberOfJobs) {
  const StabilityResult two = measure_stability(own_limits(), Runner(2));
  ASSERT_EQ(two.limits.size(), own().limits.size());
  for (std::size_t i = 0; i < two.limits.size(); ++i) {
    EXPECT_EQ(two.limits[i].solver, own().limits[i].solver);
    EXPECT_EQ(std::isnan(two.limits[i].limit), std::isnan(own().limits[i].limit));
    if (!std::isnan(two.limits[i].limit)) {
      EXPECT_EQ(two.limits[i].limit, own().limits[i].limit);
    }
    EXPECT_EQ(two.limits[i].detail, own().limits[i].detail);
  }
  ASSERT_EQ(two.regions.size(), own().regions.size());
  for (std::size_t i = 0; i < two.regions.size(); ++i)
    EXPECT_EQ(growth_text(two.regions[i]), growth_text(own().regions[i]));
}

TEST(Stability, ResultsThatWereKeptAreThoseThatWereMeasured) {
  const std::filesystem::path path =
      std::filesystem::path(::testing::TempDir()) / "odeum_stability_resume";
  std::filesystem::remove_all(path);
  Options options;
  options.solvers = {"odeum/heun", "odeum/velocity_verlet", "odeum/implicit_euler_fixed_point"};
  options.own = {{"grid", "9"}};
  {
    record::Store store(path);
    Options first = options;
    first.solvers = {"odeum/heun", "odeum/implicit_euler_fixed_point"};
    measure_stability(first, Runner(1, {.store = &store, .dependencies = "same"}));
  }
  record::Store store(path);
  const StabilityResult resumed =
      measure_stability(options, Runner(1, {.store = &store, .dependencies = "same"}));
  EXPECT_EQ(store.taken(), 10U);  // two solvers, three axes and two planes
  const StabilityResult fresh = measure_stability(options);
  ASSERT_EQ(resumed.limits.size(), fresh.limits.size());
  for (std::size_t i = 0; i < fresh.limits.size(); ++i) {
    EXPECT_EQ(resumed.limits[i].solver, fresh.limits[i].solver);
    EXPECT_EQ(resumed.limits[i].axis, fresh.limits[i].axis);
    EXPECT_EQ(resumed.limits[i].status, fresh.limits[i].status);
    EXPECT_EQ(record::format_number(resumed.limits[i].limit),
              record::format_number(fresh.limits[i].limit));
  }
  for (std::size_t i = 0; i < fresh.regions.size(); ++i)
    EXPECT_EQ(growth_text(resumed.regions[i]), growth_text(fresh.regions[i]));
  std::filesystem::remove_all(path);
}

/// RK4 with one weight of an inner stage off by a tenth of a per cent, and y' = z y to run it on.
constexpr Tableau<4> mutant_tableau{
    .a = {{{0, 0, 0, 0}, {1. / 2, 0, 0, 0}, {0, 0.5005, 0, 0}, {0, 0, 1, 0}}},
    .b = {1. / 6, 1. / 3, 1. / 3, 1. / 6},
    .order = 4,
};
struct Mutant : ForAnyProblem, ExplicitRungeKuttaMethod<mutant_tableau> {
  static constexpr MethodInfo info{
      .id = "mutant", .family = "explicit_rk", .order = 4, .source = "none"};
};

TEST(Limits, AMutantIsCaught) {
  // The mutant runs, the theory is that of the method it claims to be.
  using Problem = DahlquistLanes<1>;
  const auto problem = std::make_shared<Problem>();
  Contest<Problem> contest;
  contest.problem = problem;
  contest.y0 = std::make_shared<const std::vector<double>>(std::vector<double>{1, 0});
  Probe probe;
  probe.place = [problem](double re, double im) {
    problem->re = {re};
    problem->im = {im};
  };
  Entrant entrant{.info = info_of_own<Mutant>(), .unfit = {}, .solve = {}};
  entrant.solve = [&](const Request& request) { return solve_own<Mutant>(contest, request); };
  probe.entrants.add(entrant);
  measure::GrowthMeter meter(probe, entrant, false, measure::limit_length);
  const double measured = judge::find_limit([&](double x) { return meter.measure(-x, 0); }).limit;
  const double theory = own_by_key()[{"rk4", "real"}].theory;
  // dR/da is of the order of z^3/6 = 3.6 there, times 5e-4, over dR/dz of the order of 1.
  EXPECT_GT(std::abs(measured - theory), 1e-4);
  EXPECT_LT(std::abs(measured - theory), 1e-2);
}

}  // namespace
}  // namespace odeum::study::limits_test
