// SPDX-License-Identifier: BSD-3-Clause
// Cases of problems in foreign code, and the references that are computed for those without an
// exact solution.
#include "odeum/cases/foreign_case.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "odeum/isolated/isolated_process.hpp"
#include "odeum/solvers/foreign_evaluator.hpp"
#include "odeum/truth/foreign_reference.hpp"

namespace odeum::foreign_case_test {
namespace {

/// A problem of two unknowns from (1, 0), or whatever `y0` has.
foreign::ProblemCallbacks given(int (*rhs)(void*, double, const double*, double*), double horizon,
                                std::vector<double> start = {1, 0}) {
  struct Numbers {
    std::vector<double> y0, stops;
  };
  const auto numbers = std::make_shared<const Numbers>(
      Numbers{std::move(start), {horizon / 4, horizon / 2, 3 * horizon / 4, horizon}});
  foreign::ProblemCallbacks given;
  given.functions.name = "test";
  given.functions.dimension = numbers->y0.size();
  given.functions.y0 = numbers->y0.data();
  given.functions.stops = numbers->stops.data();
  given.functions.stop_count = numbers->stops.size();
  given.functions.rhs = rhs;
  given.keep_alive = numbers;
  given.id = "test";
  given.provider = "the test";
  given.tag = "plugin";
  given.source = "a test";
  return given;
}

int oscillator(void*, double, const double* y, double* f) {
  f[0] = y[1];
  f[1] = -y[0];
  return 0;
}
/// Eigenvalues -1 and -1e5, y0 = exp(-t) once the fast part is over.
int stiff(void*, double, const double* y, double* f) {
  f[0] = -y[0];
  f[1] = 1e5 * (y[0] * y[0] - y[1]);
  return 0;
}
/// y' = cos t, z' = 2 t y with a long horizon: depends on t.
int in_time(void*, double t, const double* y, double* f) {
  f[0] = std::cos(t);
  f[1] = 2 * t * y[0];
  return 0;
}
/// A pulse between 50.033 - w and 50.033 + w, with edges, or smooth.
template <int PerMille>
int pulse(void*, double t, const double* y, double* f) {
  f[0] = (std::abs(t - 50.033) < PerMille / 1000.0 ? 100 : 0) - 0.1 * y[0];
  f[1] = 0;
  return 0;
}
template <int PerMille>
int smooth_pulse(void*, double t, const double* y, double* f) {
  const double at = (t - 50.033) / (PerMille / 1000.0);
  f[0] = std::exp(-at * at);
  f[1] = -y[1];
  return 0;
}
int hangs_after_one(void*, double t, const double* y, double* f) {
  while (t > 1) ::pause();
  return oscillator(nullptr, t, y, f);
}
/// Ended, and not waited for by whoever inherited it.
bool is_zombie(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string word;
  for (int k = 0; k < 3; ++k) in >> word;
  return word == "Z";
}
int aborts(void*, double, const double* y, double* f) {
  if (y[0] < 0.5) std::abort();
  return oscillator(nullptr, 0, y, f);
}
int lorenz(void*, double, const double* y, double* f) {
  f[0] = 10 * (y[1] - y[0]);
  f[1] = y[0] * (28 - y[2]) - y[1];
  f[2] = y[0] * y[1] - 8 * y[2] / 3;
  return 0;
}

truth::Reference reference(const foreign::ProblemCallbacks& problem) {
  std::string why;
  auto found = truth::reference_of(problem, why);
  if (!found) throw std::runtime_error(why);
  return *found;
}

/// The largest error at a time that is known, over the bound that is claimed there.
template <class Exact>
double worst_over_claim(const truth::Reference& r, std::size_t component, Exact exact) {
  double worst = 0;
  for (std::size_t k = 0; k < r.times.size(); ++k) {
    const long double error =
        std::abs(r.states[k][component] - exact(static_cast<long double>(r.times[k])));
    worst = std::max(worst, static_cast<double>(error) / r.floors[k][component]);
  }
  return worst;
}

TEST(ForeignReference, KeepsWhatItClaimsForAnOscillator) {
  const truth::Reference r = reference(given(oscillator, 50));
  EXPECT_EQ(r.known_until, 50) << r.end;
  EXPECT_LE(worst_over_claim(r, 0, [](long double t) { return std::cos(t); }), 1);
  // Rounding of double in 50 units of time.
  EXPECT_LT(r.floors.back()[0], 1e-12);
}

TEST(ForeignReference, KeepsWhatItClaimsForAStiffProblem) {
  const truth::Reference r = reference(given(stiff, 2));
  EXPECT_EQ(r.known_until, 2) << r.end;
  EXPECT_NE(r.methods.find("Radau"), std::string::npos) << r.methods;
  EXPECT_LE(worst_over_claim(r, 0, [](long double t) { return std::exp(-t); }), 1);
  // z' = k (exp(-2t) - z): z = k / (k - 2) (exp(-2 t) - exp(-k t)).
  EXPECT_LE(worst_over_claim(r, 1,
                             [](long double t) {
                               const long double k = 1e5L;
                               return k / (k - 2) * (std::exp(-2 * t) - std::exp(-k * t));
                             }),
            1);
  EXPECT_LT(r.floors.back()[1], 1e-10);
}

TEST(ForeignReference, KeepsWhatItClaimsWhereTimeMatters) {
  const truth::Reference r = reference(given(in_time, 20, {0, 0}));
  EXPECT_EQ(r.known_until, 20) << r.end;
  EXPECT_LE(worst_over_claim(r, 0, [](long double t) { return std::sin(t); }), 1);
  EXPECT_LE(
      worst_over_claim(r, 1, [](long double t) { return 2 * (std::sin(t) - t * std::cos(t)); }), 1);
}

/// Both methods stepped over it, agreed, and full digits were claimed for what is off by all.
TEST(ForeignReference, SeesPulsesThatAreLongerThanItSays) {
  const auto expect_true = [](const truth::Reference& r, long double exact) {
    ASSERT_FALSE(r.times.empty()) << r.end;
    if (r.known_until < 100) return;  // nothing false is claimed
    EXPECT_LE(std::abs(r.states.back()[0] - exact), r.floors.back()[0] + 2e-14)
        << r.floors.back()[0];
  };
  // 0.01 is the ten thousandth part of the horizon; pulses of twice 0.008, 0.05, 0.5.
  const auto of_edges = [](long double w) {
    return 1000 * (std::exp(-0.1L * (49.967L - w)) - std::exp(-0.1L * (49.967L + w)));
  };
  expect_true(reference(given(pulse<8>, 100, {0, 1})), of_edges(0.008L));
  expect_true(reference(given(pulse<50>, 100, {0, 1})), of_edges(0.05L));
  expect_true(reference(given(pulse<500>, 100, {0, 1})), of_edges(0.5L));
  const auto area = [](long double w) { return w * std::sqrt(std::acos(-1.0L)); };
  expect_true(reference(given(smooth_pulse<10>, 100, {0, 1})), area(0.01L));
  expect_true(reference(given(smooth_pulse<100>, 100, {0, 1})), area(0.1L));
  expect_true(reference(given(smooth_pulse<1000>, 100, {0, 1})), area(1));
}

TEST(ForeignReference, SaysFromWhereOnNothingIsKnown) {
  const truth::Reference r = reference(given(lorenz, 100, {1, 1, 1}));
  // Errors grow by e each unit of time or so: 1e-15 is 1e-6 after some 25.
  EXPECT_GT(r.known_until, 10);
  EXPECT_LT(r.known_until, 50);
  EXPECT_NE(r.end.find("agree on less"), std::string::npos) << r.end;
}

TEST(ForeignReference, CodeThatEndsItsProcessHasNone) {
  std::string why;
  EXPECT_FALSE(truth::reference_of(given(aborts, 5), why));
  EXPECT_NE(why.find("crashed: Aborted"), std::string::npos) << why;
  EXPECT_FALSE(truth::reference_of(given(oscillator, 5, std::vector<double>(1001, 1)), why));
  EXPECT_NE(why.find("up to 1000 unknowns"), std::string::npos) << why;
}

TEST(ForeignCase, WithoutAnExactSolutionHasAComputedTruthAndSteps) {
  foreign::ProblemCallbacks problem = given(oscillator, 10);
  problem.content = "ForeignCase oscillator";
  const Case c = case_of(cases::foreign_statement(problem));
  double y[2];
  ASSERT_TRUE(c.truth.at(10, y));
  EXPECT_NEAR(y[0], std::cos(10.0), c.truth.floor);
  EXPECT_TRUE(c.settings.no_convergence.empty()) << c.settings.no_convergence;
  EXPECT_TRUE(c.settings.no_fixed_steps.empty()) << c.settings.no_fixed_steps;
  EXPECT_EQ(c.facts.back().first, "truth");
}

TEST(ForeignCase, WithoutATruthSaysSo) {
  foreign::ProblemCallbacks problem = given(aborts, 5);
  problem.content = "ForeignCase aborts";
  const Case c = case_of(cases::foreign_statement(problem));
  double y[2];
  EXPECT_FALSE(c.truth.at(5, y));
  EXPECT_NE(c.settings.no_convergence.find("no truth is known"), std::string::npos);
  EXPECT_NE(c.settings.no_convergence.find("crashed: Aborted"), std::string::npos);
}

// A study of thousands of runs waited 5 s for each of a solver that never returned.
TEST(ForeignRuns, ASolverThatHadToBeEndedAgainAndAgainIsNotRunAgain) {
  EXPECT_EQ(isolated::longest_silence(), 5);
  ::setenv("ODEUM_SILENCE_SECONDS", "0.5", 1);
  bool hangs = true;
  const auto solve = [&](const Request&) {
    if (hangs) ::pause();
    return Outcome();
  };
  Request request;
  request.stops = {1};
  isolated::Ended ended = isolated::most_ended - 2;
  const auto run = [&] { return isolated::solve_isolated(solve, request, 1, ended); };
  const Outcome silent = run();
  EXPECT_EQ(silent.status, Status::over_budget);
  EXPECT_NE(silent.detail.find("for 0.5 s"), std::string::npos) << silent.detail;
  EXPECT_EQ(ended, isolated::most_ended - 1);
  hangs = false;
  EXPECT_EQ(run().status, Status::ok);
  EXPECT_EQ(ended, 0U) << "three in a row count";
  ended = isolated::most_ended;
  const Outcome outcome = run();
  EXPECT_EQ(outcome.status, Status::refused);
  EXPECT_NE(outcome.detail.find("not run, since 3 runs before"), std::string::npos);
}

// Its row said that nothing was evaluated.
TEST(ForeignRuns, AProcessThatHadToBeEndedIsCountedUntilThen) {
  ::setenv("ODEUM_SILENCE_SECONDS", "0.5", 1);
  foreign::ProblemCallbacks problem = given(hangs_after_one, 5);
  problem.content = "ForeignRuns hangs";
  const Case c = case_of(cases::foreign_statement(problem));
  for (const Entrant& entrant : c.entrants) {
    if (entrant.info.id() != "odeum/rk4") continue;
    const Outcome outcome = entrant.solve({.mode = Mode::fixed, .steps = 40, .stops = {5}});
    EXPECT_EQ(outcome.status, Status::over_budget);
    // Eight steps to t = 1, a stage there, and the one at t = 1.0625 that did not return.
    EXPECT_EQ(outcome.counters.rhs_evaluations, 34U) << outcome.detail;
    EXPECT_EQ(outcome.counters.work, 34U);
    return;
  }
  FAIL() << "no solver";
}

// Twenty calls waited for, one after the other; and a killed parent left the process that hung.
TEST(ForeignRuns, AProcessThatHangsIsAskedThreeTimesAndEndsWithoutItsParent) {
  ::setenv("ODEUM_SILENCE_SECONDS", "0.2", 1);
  const auto calls = std::make_shared<isolated::SharedMemory>(2 * sizeof(int));
  auto* const seen = static_cast<int*>(calls->get());
  foreign::Evaluator evaluator(
      [seen](int, double, const double*, double*) {
        ++seen[0];
        seen[1] = ::getpid();
        return ::pause();
      },
      1);
  double x = 0;
  for (int k = 0; k < 6; ++k) EXPECT_FALSE(evaluator.call(0, 0, &x, 1, &x, 1));
  EXPECT_EQ(seen[0], static_cast<int>(isolated::most_ended));
  seen[1] = 0;
  const pid_t parent = isolated::start_child(isolated::Lifetime::thread, [&] {
    foreign::Evaluator orphan(
        [seen](int, double, const double*, double*) {
          seen[1] = ::getpid();
          return ::pause();
        },
        1);
    orphan.call(0, 0, &x, 1, &x, 1);
  });
  while (seen[1] == 0) ::usleep(1000);
  // The parent dies alone, as by kill -9, and not with its group.
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  int waited = 0;
  while (::kill(seen[1], 0) == 0 && waited < 6000 && !is_zombie(seen[1])) ::usleep(10000), ++waited;
  EXPECT_LT(waited, 6000) << "process " << seen[1] << " is still there";
}

}  // namespace
}  // namespace odeum::foreign_case_test
