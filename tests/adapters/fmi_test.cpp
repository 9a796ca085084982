// SPDX-License-Identifier: BSD-3-Clause
// FMUs that the build makes of tests/package/fmi: what runs, and what is refused with which reason.
#include <cmath>
#include <stdexcept>

#include "fmi_stage.hpp"
#include "odeum/advise/race.hpp"
#include "odeum/cases/set_problem.hpp"

namespace odeum::fmi_tests::fmi_test {
namespace {

const Entrant& entrant(const Case& c, const std::string& id) {
  for (const Entrant& e : c.entrants)
    if (e.info.id() == id) return e;
  throw std::runtime_error("no solver " + id);
}

/// The model that the FMU has, without a force.
struct VanDerPol {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* f) const {
    f[0] = y[1];
    f[1] = (1 - y[0] * y[0]) * y[1] - y[0];
  }
  void jacobian(double, const double* y, double* j) const {
    j[0] = 0, j[1] = 1;
    j[2] = -2 * y[0] * y[1] - 1, j[3] = 1 - y[0] * y[0];
  }
};

Outcome solve(const Case& c, const std::string& id, double tolerance = 1e-9) {
  Request request{.mode = Mode::adaptive, .tolerance = tolerance, .stops = c.stops};
  return entrant(c, id).solve(request);
}

// Making the process of each run takes far longer than the run, and is none of it: in the race all
// have their turn.
TEST_P(Fmus, AdviceTriesEverySolverThatFits) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "runs that take milliseconds have no turn where others foresee less";
#endif
  const Case c = made({{"mu", "0"}, {"x", "1"}});
  advise::Wishes wishes;
  wishes.error = 1e-4;
  wishes.solvers = {"odeum/*54*", "gsl/*"};
  wishes.clock = [] { return 0.0; };  // no race against the machine's time
  const advise::Advice advice = advise::advise({&c}, wishes);
  EXPECT_TRUE(advice.failure.empty()) << advice.failure;
  for (const advise::Candidate& candidate : advice.candidates)
    EXPECT_FALSE(candidate.trials.empty()) << candidate.entrant->info.id();
}

TEST_P(Fmus, ALinearModelHasTheClosedFormForTruthAndIsSolved) {
  const Case c = made({{"mu", "0"}, {"x", "1"}});
  EXPECT_EQ(c.components, (std::vector<std::string>{"x", "v"}));
  EXPECT_EQ(c.stops, (std::vector<double>{2, 4, 6, 8}));
  EXPECT_EQ(c.y0, (std::vector<double>{1, 0}));
  EXPECT_TRUE(c.nature.autonomous);
  EXPECT_LT(c.truth.floor, 1e-11);
  double y[2];
  for (const double t : c.stops) {
    ASSERT_TRUE(c.truth.at(t, y)) << c.truth.source;
    EXPECT_NEAR(y[0], std::cos(t), c.truth.floor);
    EXPECT_NEAR(y[1], -std::sin(t), c.truth.floor);
  }
  for (const char* id : {"odeum/dormand_prince54", "odeum/rodas4", "odeum/radau_iia5"}) {
    const Outcome outcome = solve(c, id);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    // A tolerance of 1e-9 a step, on a problem that magnifies no error.
    EXPECT_NEAR(outcome.states[6], std::cos(8.0), 1e-6) << id;
  }
}

TEST_P(Fmus, TheJacobianIsThatOfDirectionalDerivatives) {
  const Case c = made();
  ASSERT_TRUE(c.problem.view.jacobian);
  double j[4];
  const double y[2] = {0.5, 3};
  c.problem.view.jacobian(c.problem.view.problem, 1, y, j);
  EXPECT_DOUBLE_EQ(j[0], 0);
  EXPECT_DOUBLE_EQ(j[1], 1);
  EXPECT_DOUBLE_EQ(j[2], -2 * 0.5 * 3 - 1);
  EXPECT_DOUBLE_EQ(j[3], 1 - 0.25);
  const std::string provides = three() ? "providesDirectionalDerivatives=\"true\""
                                       : "providesDirectionalDerivative=\"true\"";
  const foreign::ProblemCallbacks without =
      open_fmu(fmu([&](std::string& xml) { replace(xml, provides, ""); }));
  EXPECT_EQ(without.functions.jacobian, nullptr);
}

TEST_P(Fmus, AModelThatDependsOnTimeHasItsTimeDerivative) {
  const Case c = made({{"a", "3"}});
  EXPECT_FALSE(c.nature.autonomous);
  ASSERT_TRUE(c.problem.view.time_derivative);
  for (const double t : {0.0, 1.0, 8.0}) {
    double d[2];
    c.problem.view.time_derivative(c.problem.view.problem, t, c.y0.data(), d);
    EXPECT_EQ(d[0], 0);
    // Differences over 8e-6 of numbers near 3: a rounding of 1e-10.
    EXPECT_NEAR(d[1], 3 * std::cos(t), 1e-8) << t;
  }
  // What a Rosenbrock method would miss without it.
  const Outcome a = solve(c, "odeum/rodas4"), b = solve(c, "odeum/dormand_prince853");
  ASSERT_EQ(a.status, Status::ok) << a.detail;
  EXPECT_NEAR(a.states[6], b.states[6], 1e-6);
}

TEST_P(Fmus, ValuesThatCannotBeSetAreRefused) {
  const std::string file = fmu();
  expect_refused(file, "no variable nu; it has x, v, mu, a, fault", {{"nu", "1"}});
  expect_refused(file, "der(x) is computed or constant", {{"der(x)", "1"}});
  expect_refused(file, "got \"one\", expected a number", {{"mu", "one"}});
  expect_refused(file, "expected a whole number", {{"fault", "1.5"}});
}

TEST_P(Fmus, OtherBinariesAreRefused) {
  Entries other = entries();
  other[1].first = "binaries/win64/oscillator.dll";
  expect_refused(archive(other), "it has those for win64");
  expect_refused(archive({entries()[0]}), "it has none at all");
  Entries text = entries();
  text[1].second = "no shared object";
  expect_refused(archive(text), "cannot be loaded");
  // The binary of the other version has none of the functions; one lacks a single one.
  expect_refused(archive(entries({}, three() ? ODEUM_FMI2 : ODEUM_FMI3)),
                 "exports no function fmi");
  if (!three())
    expect_refused(archive(entries({}, ODEUM_FMI2_WITHOUT)),
                   "exports no function fmi2GetDerivatives");
  expect_refused_xml("{oscillator}", "{another}", "is another");
}

TEST_P(Fmus, WhatFailsAtTheStartIsRefused) {
  const std::string file = fmu();
  expect_refused(file, "rhs fails or is not finite at t = 0", {{"fault", "1"}});
  expect_refused(file, "EnterInitializationMode returned error", {{"fault", "7"}});
  expect_refused(file, "foreign code crashed: Aborted", {{"fault", "9"}});
}

// One has a time event, another one asks for an event at the end of a step.
TEST_P(Fmus, ModelsWithEventsAreKnownAtTheStart) {
  EXPECT_FALSE(open_fmu(fmu()).events);
  for (const char* fault : {"6", "8"}) EXPECT_TRUE(open_fmu(fmu(), {{"fault", fault}}).events);
}

// From x = 2 the model fails once x < 1, near t = 1.7.
TEST_P(Fmus, WhatFailsLaterCostsItsSolvesOnly) {
  const std::pair<const char*, const char*> faults[] = {{"3", "crashed: Aborted"},
                                                        {"5", "exit code 0"}};
  for (const auto& [fault, why] : faults) {
    const Case c = made({{"fault", fault}});
    double y[2];
    EXPECT_FALSE(c.truth.at(8, y)) << fault;
    EXPECT_NE(c.settings.no_convergence.find(why), std::string::npos) << c.settings.no_convergence;
    const Outcome outcome = solve(c, "odeum/dormand_prince54");
    EXPECT_EQ(outcome.status, Status::refused) << fault;
    EXPECT_NE(outcome.detail.find(why), std::string::npos) << fault << ": " << outcome.detail;
  }
}

TEST_P(Fmus, ATruthEndsWhereTheModelDoes) {
  for (const char* fault : {"2", "10"}) {
    Case c = made({{"fault", fault}});
    ASSERT_EQ(c.stops.size(), 1U);
    EXPECT_GT(c.stops[0], 1);
    EXPECT_LT(c.stops[0], 2);
    c.stops = {8};
    const Outcome outcome = solve(c, "odeum/dormand_prince54");
    EXPECT_TRUE(outcome.status == Status::non_finite || outcome.status == Status::step_too_small)
        << to_string(outcome.status) << outcome.detail;
  }
}

TEST_P(Fmus, AModelThatHangsIsEnded) {
  const Case c = made({{"fault", "4"}});
  EXPECT_NE(c.settings.no_convergence.find("was ended"), std::string::npos)
      << c.settings.no_convergence;
  const Outcome outcome = solve(c, "odeum/dormand_prince54");
  EXPECT_EQ(outcome.status, Status::over_budget) << outcome.detail;
}

// Every solver of every library, with a budget that some of them exceed.
TEST_P(Fmus, RunsAreCountedAndBudgetedAsThoseOfCompiledProblems) {
  const Case model = made();
  Case native;
  native.y0 = model.y0, native.stops = model.stops;
  cases::set_problem(native, VanDerPol{});
  Request request{.mode = Mode::adaptive, .tolerance = 1e-6, .stops = model.stops};
  request.budget.evaluations = 800;
  int compared = 0, spent = 0;
  for (const Entrant& own : native.entrants) {
    if (!own.unfit.empty()) continue;
    const Outcome expected = own.solve(request),
                  found = entrant(model, own.info.id()).solve(request);
    EXPECT_EQ(found.status, expected.status) << own.info.id() << found.detail << expected.detail;
    EXPECT_EQ(found.detail, expected.detail) << own.info.id();
    EXPECT_EQ(found.counters.rhs_evaluations, expected.counters.rhs_evaluations) << own.info.id();
    EXPECT_EQ(found.counters.jacobian_evaluations, expected.counters.jacobian_evaluations)
        << own.info.id();
    EXPECT_EQ(found.counters.steps, expected.counters.steps) << own.info.id();
    ++compared, spent += expected.status == Status::over_budget;
  }
  EXPECT_GT(compared, 50);
  EXPECT_GT(spent, 5);
}

INSTANTIATE_TEST_SUITE_P(Versions, Fmus, testing::Values(2, 3));

}  // namespace
}  // namespace odeum::fmi_tests::fmi_test
