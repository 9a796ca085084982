// SPDX-License-Identifier: BSD-3-Clause
#include "odepack/solvers.hpp"

#include <gtest/gtest.h>

#include <thread>

#include "adapters/peer_stage.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/problem/sparsity.hpp"
#include "odeum/solvers/case.hpp"
#include "support/enrolled.hpp"

/// LSODA, LSODE, VODE and RADAU5.
namespace odeum::test::odepack_test {
namespace {

std::vector<Entrant> enrolled(Circle problem) {
  return tests::enrolled_on(erase(circle(problem)), adapters::odepack::add_solvers);
}

TEST(Odepack, EachSolverIsHonest) {
  EXPECT_EQ(enrolled({}).size(), 6u);
  for (const Entrant& entrant : enrolled({})) {
    // Two libraries have a method of one name.
    expect_honest(entrant, [&](Circle problem) {
      std::vector<Entrant> same = enrolled(problem);
      std::erase_if(same, [&](const Entrant& e) { return e.info.id() != entrant.info.id(); });
      return same;
    });
    expect_converges_with_tolerance(entrant);
  }
}

TEST(Odepack, AFastStartIsNoObstacleToALongHorizon) {
  const std::vector<Entrant> entrants =
      tests::enrolled_on(erase(contest_of(Approach{}, {2})), adapters::odepack::add_solvers);
  expect_long_horizon(entrants, {"lsoda", "lsode_bdf", "bdf", "radau5"});
}

// The state is in Fortran's common blocks: runs of several threads wait for one another.
TEST(Odepack, ThreadsAgreeWithOne) {
  for (const Entrant& entrant : enrolled({})) {
    const Outcome alone = entrant.solve(adaptive_request(1e-8));
    std::vector<Outcome> outcomes(4);
    std::vector<std::thread> threads;
    for (Outcome& outcome : outcomes)
      threads.emplace_back([&] {
        for (int k = 0; k < 5; ++k) outcome = entrant.solve(adaptive_request(1e-8));
      });
    for (std::thread& thread : threads) thread.join();
    for (const Outcome& outcome : outcomes)
      EXPECT_EQ(outcome.states, alone.states) << entrant.info.id();
  }
}

// A run that was left in the middle changes nothing of the next.
TEST(Odepack, ARunThatIsLeftDoesNotChangeTheNext) {
  for (const Entrant& entrant : enrolled({})) {
    const Outcome first = entrant.solve(adaptive_request(1e-8));
    Request poor = adaptive_request(1e-8);
    poor.budget.evaluations = 17;
    EXPECT_EQ(entrant.solve(poor).status, Status::over_budget) << entrant.info.id();
    EXPECT_EQ(entrant.solve(adaptive_request(1e-8)).states, first.states) << entrant.info.id();
  }
}

/// y_i' = rate (y_{i-1} - 2 y_i + y_{i+1}): of each Fourier mode the decay is known.
struct Heat {
  static constexpr std::size_t dimension = dynamic;
  static constexpr double rate = 1e4;
  std::size_t n = 200;
  Sparsity pattern = banded_sparsity(n, 1, 1);
  std::size_t size() const { return n; }
  const Sparsity* sparsity() const { return &pattern; }
  void rhs(double, const double* y, double* dydt) const {
    for (std::size_t i = 0; i < n; ++i)
      dydt[i] = rate * ((i > 0 ? y[i - 1] : 0) - 2 * y[i] + (i + 1 < n ? y[i + 1] : 0));
  }
  void jacobian_entries(double, const double*, double* values) const {
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = i > 0 ? i - 1 : 0; j < std::min(i + 2, n); ++j)
        *values++ = i == j ? -2 * rate : rate;
  }
};

// More unknowns than a dense matrix may have.
TEST(Odepack, ABandTakesThePlaceOfTheFullMatrix) {
  const Heat heat;
  std::vector<double> y0;
  const double wave = M_PI / static_cast<double>(heat.n + 1);
  for (std::size_t i = 1; i <= heat.n; ++i) y0.push_back(std::sin(wave * static_cast<double>(i)));
  const double decay = 2 * Heat::rate * (1 - std::cos(wave));
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = 1e-7;
  request.stops = {0.1, 0.5};
  for (const Entrant& entrant :
       tests::enrolled_on(erase(contest_of(heat, y0)), adapters::odepack::add_solvers)) {
    if (entrant.info.id() == "odepack/lsode_adams" || entrant.info.id() == "vode/adams") continue;
    const Outcome outcome = entrant.solve(request);
    ASSERT_EQ(outcome.status, Status::ok) << entrant.info.id() << ": " << outcome.detail;
    // Some hundred steps of local errors at the tolerance, which the problem damps.
    for (std::size_t k = 0; k < 2; ++k)
      EXPECT_NEAR(outcome.states[k * heat.n + heat.n / 2],
                  std::exp(-decay * request.stops[k]) * y0[heat.n / 2], 1e-5)
          << entrant.info.id();
    EXPECT_LT(outcome.counters.rhs_evaluations, 2000u) << entrant.info.id();
  }
}

TEST(Odepack, DenseMatricesHaveALimit) {
  for (const Entrant& entrant :
       tests::enrolled_on(erase(contest_of(Wide{}, std::vector<double>(Wide{}.size(), 1))),
                          adapters::odepack::add_solvers)) {
    const bool without = entrant.info.method == "lsode_adams" || entrant.info.id() == "vode/adams";
    EXPECT_EQ(entrant.solve(adaptive_request(1e-3)).status,
              without ? Status::ok : Status::over_budget)
        << entrant.info.id();
  }
}

// Outputs come from the polynomial of a step, and the steps stay as they are.
TEST(Odepack, OutputsDoNotChangeItsSteps) {
  for (const Entrant& entrant : enrolled({})) {
    Request sparse = adaptive_request(1e-8), many = sparse;
    sparse.stops = {2};
    many.stops.clear();
    for (int k = 1; k <= 40; ++k) many.stops.push_back(k * 0.05);
    many.over_stops = many.record_steps = true;
    const Outcome one = entrant.solve(sparse), all = entrant.solve(many);
    ASSERT_EQ(all.status, Status::ok) << entrant.info.id() << ": " << all.detail;
    EXPECT_EQ(all.counters.steps, one.counters.steps) << entrant.info.id();
    EXPECT_EQ(all.step_ends.size(), all.counters.steps) << entrant.info.id();
    EXPECT_EQ(all.states.back(), one.states.back()) << entrant.info.id();
    for (std::size_t k = 0; k < many.stops.size(); ++k)  // RADAU5's polynomial is of degree 3
      EXPECT_NEAR(all.states[2 * k], std::sin(many.stops[k]), 1e-5) << entrant.info.id();
  }
}

/// Robertson's reactions as the documentations of LSODE and LSODA have them, to 4e10.
Outcome robertson(const char* solver) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = Tolerance(1e-4, {1e-6, 1e-10, 1e-6});
  for (int k = -1; k <= 10; ++k) request.stops.push_back(4 * std::pow(10., k));
  return known_case("robertson").entrants.find(solver)->solve(request);
}

struct Printed {
  const char* solver;
  double at_40[3];  ///< state
  std::uint64_t steps, evaluations, jacobians;
  bool by_formula;  ///< Jacobians cost no evaluations
};

// What their documentations print, of a Cray and a CDC: states at t = 40 to a tenth of a unit of
// the tolerance of 1e-4, and counts, which follow the rounding of the machine, to a tenth.
TEST(Odepack, TheExamplesOfTheDocumentationAreReproduced) {
  for (const Printed& printed :
       {Printed{
            "odepack/lsode_bdf", {7.158050e-01, 9.184616e-06, 2.841858e-01}, 330, 405, 69, true},
        {"odepack/lsoda",
         {7.158403e-01, 9.186334e-06, 2.841505e-01},
         361,
         693 - 3 * 64,
         64,
         true}}) {
    const Outcome outcome = robertson(printed.solver);
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(outcome.states[6 + i], printed.at_40[i], 1e-4 * printed.at_40[i])
          << printed.solver << ' ' << i;
    const auto near = [](std::uint64_t count, std::uint64_t other) {
      return std::abs(static_cast<double>(count) / static_cast<double>(other) - 1) < 0.1;
    };
    const Counters& counters = outcome.counters;
    EXPECT_TRUE(near(counters.steps, printed.steps)) << counters.steps;
    EXPECT_TRUE(near(counters.rhs_evaluations, printed.evaluations)) << counters.rhs_evaluations;
    EXPECT_TRUE(near(counters.jacobian_evaluations, printed.jacobians))
        << counters.jacobian_evaluations;
  }
}

/// Van der Pol's oscillator with mu = 1e6 in the variables of the documentation of Assimulo.
struct VanDerPol {
  static constexpr std::size_t dimension = 2;
  static constexpr double mu = 1e6;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = y[1];
    dydt[1] = mu * ((1 - y[0] * y[0]) * y[1] - y[0]);
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = 0;
    j[1] = 1;
    j[2] = mu * (-2 * y[0] * y[1] - 1);
    j[3] = mu * (1 - y[0] * y[0]);
  }
};

// It prints of RADAU5 from (2, -0.6) to t = 2 at 1e-4: 241 steps, 2233 evaluations, 160 Jacobians
// and 7 failures. The first step is another there, and a loop of steps at the corner differs by
// some.
TEST(Odepack, Radau5StepsAsPublished) {
  const auto entrants =
      tests::enrolled_on(erase(contest_of(VanDerPol{}, {2, -0.6})), adapters::odepack::add_solvers);
  Request request = adaptive_request(1e-4);
  request.stops = {2};
  const Outcome outcome = find(entrants, "radau5").solve(request);
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  EXPECT_NEAR(static_cast<double>(outcome.counters.steps), 241, 12);
  EXPECT_NEAR(static_cast<double>(outcome.counters.rhs_evaluations), 2233, 112);
  EXPECT_NEAR(static_cast<double>(outcome.counters.jacobian_evaluations), 160, 8);
  // The end state of Hairer's page of test problems, to 15 digits.
  EXPECT_NEAR(outcome.states[0], 1.706167732170469, 2e-3);
}

}  // namespace
}  // namespace odeum::test::odepack_test
