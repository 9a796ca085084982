// SPDX-License-Identifier: BSD-3-Clause
// Runs that failed, or ended ok far from the truth, without need.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "odeum/cases/scene_case.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/judge/amplification.hpp"
#include "odeum/judge/answer.hpp"
#include "odeum/scene/read/reader.hpp"
#include "odeum/scene/run/run.hpp"
#include "support/catalogue.hpp"
#include "support/own_runs.hpp"
#include "support/scene_texts.hpp"

namespace odeum::tests::hard_runs_test {
namespace {

// The first step that initial_step guesses there, 1e-6, is shorter than 4e10 can be told from its
// neighbour.
TEST(HardRuns, ALateStartIsNoFailure) {
  const Case& c = find_case("robertson");
  ErasedContest late = c.problem;
  std::vector<double> y(c.y0.size()), exact(c.y0.size());
  ASSERT_TRUE(c.truth.at(4e10, y.data()));
  ASSERT_TRUE(c.truth.at(4e11, exact.data()));
  late.t0 = 4e10;
  late.y0 = std::make_shared<const std::vector<double>>(y);
  for (const char* method :
       {"radau_iia5", "radau_iia9", "sdirk4", "esdirk43", "rodas4", "seulex"}) {
    SCOPED_TRACE(method);
    const Outcome outcome = run_own(method, late, adaptive_request(1e-8, {4e11}));
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    // 100 tolerances; an error does not grow on this slow decay.
    for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(outcome.states[i], exact[i], 1e-6);
  }
}

/// The largest error over the truth's size at a fixed step; 0 where the run did not end ok.
double relative_error(const Case& c, const char* solver, std::uint64_t steps) {
  const Outcome outcome = find_entrant(c, solver).solve(fixed_request(steps, c.stops));
  if (outcome.status != Status::ok) return 0;
  const judge::Judge judge(c, c.stops);
  double error = 0;
  for (const judge::StopError& e : judge.errors(outcome)) error = std::max(error, e.error_max);
  return error / judge.scale();
}

// It ended ok with states of 1e58: nothing looked whether the step was too long for its Jacobian.
TEST(HardRuns, SeulexDoesNotEndOkFarFromRobertson) {
  const Case& c = find_case("robertson_40");
  for (const std::uint64_t steps : {500, 1000, 1410, 2830, 4000})
    EXPECT_LT(relative_error(c, "odeum/seulex", steps), 1) << steps;
}

// Newton's corrections from the state before the step led away; guesses of later stages on the far
// side of zero led to the other root of the quadratic reaction, from which the run went off to
// minus infinity.
TEST(HardRuns, ImplicitMethodsSolveRobertsonAtAFixedStep) {
  const Case& c = find_case("robertson_40");
  for (const char* solver : {"odeum/implicit_euler", "odeum/implicit_midpoint", "odeum/sdirk2",
                             "odeum/sdirk4", "odeum/esdirk43", "odeum/tr_bdf2"})
    for (const std::uint64_t steps : {500, 1000, 1410, 2000, 4000}) {
      const Outcome outcome = find_entrant(c, solver).solve(fixed_request(steps, c.stops));
      ASSERT_EQ(outcome.status, Status::ok) << solver << ' ' << steps << ' ' << outcome.detail;
      EXPECT_LT(relative_error(c, solver, steps), 0.01) << solver << ' ' << steps;
    }
}

// In the step before its last, the estimates of successive lines are 220, 49 and 0.17 tolerances,
// where the errors are 540, 250 and 240: it passes through zero, and the step was accepted.
TEST(HardRuns, AnExtrapolationsVanishingEstimateIsNotBelieved) {
  const Case& c = find_case("damped_oscillator_overdamped");
  const judge::Judge judge(c, c.stops);
  const judge::Amplification amplification = judge::measure_amplification(c, c.stops);
  const Outcome outcome =
      find_entrant(c, "odeum/gragg_bulirsch_stoer").solve(adaptive_request(1e-8, c.stops));
  ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
  const auto judged = judge::judge_answer(judge.errors(outcome), amplification, 1e-8, 100,
                                          c.truth.floor, judge.scale());
  EXPECT_EQ(judged.answer, judge::Answer::explained) << judged.reason;
}

// Newton's remainder, multiplied by weights of up to 28, was a floor at 2.6e-11.
TEST(HardRuns, Sdirk4OnTheFallWithDragConvergesToRounding) {
  const Case& c = find_case("freefall_drag");
  const judge::Judge judge(c, c.stops);
  const double unit = 0x1p-53 * judge::perturbation_gain(c);
  for (const std::uint64_t steps : {2560, 5120, 10240}) {
    const Outcome outcome = find_entrant(c, "odeum/sdirk4").solve(fixed_request(steps, c.stops));
    ASSERT_EQ(outcome.status, Status::ok) << outcome.detail;
    // Order 4 leaves 8e-14 at 2560 steps. Rounding of own methods lies within 60 times that of
    // every step at random.
    const double rounding = unit * (8 + std::sqrt(static_cast<double>(steps)));
    for (const judge::StopError& e : judge.errors(outcome))
      EXPECT_LT(e.error_rms, 60 * rounding) << steps;
  }
}

// Linearly implicit methods step over a pole without noticing: an infinite truth says so.
TEST(HardRuns, AStatePastAPoleIsWrong) {
  const Case& c = find_case("blow_up");
  const judge::Judge judge(c, c.stops);
  EXPECT_TRUE(judge.solution_ends());
  int past = 0;
  for (const Entrant& entrant : c.entrants) {
    if (!entrant.solve) continue;
    for (const std::uint64_t steps : {40, 100, 1000}) {
      if (!entrant.info.fixed) continue;
      const Outcome outcome = entrant.solve(fixed_request(steps, c.stops));
      if (outcome.status != Status::ok) continue;
      const auto judged = judge::judge_fixed_answer(judge.errors(outcome), judge.scale());
      EXPECT_EQ(judged.answer, judge::Answer::wrong) << entrant.info.id();
      EXPECT_NE(judged.reason.find("the solution is infinite before that time"), std::string::npos)
          << judged.reason;
      ++past;
    }
    if (!entrant.info.adaptive) continue;
    const Outcome outcome = entrant.solve(adaptive_request(1e-6, c.stops));
    if (outcome.status != Status::ok) continue;
    EXPECT_NE(entrant.info.library, "odeum") << entrant.info.method;
    const judge::Amplification none{.at_stops = {1, 1}, .controls = {}, .unknown = {}};
    const auto judged =
        judge::judge_answer(judge.errors(outcome), none, 1e-6, 10, 0, judge.scale());
    EXPECT_EQ(judged.answer, judge::Answer::wrong) << entrant.info.id();
  }
  EXPECT_GE(past, 6);
}

// Without a truth: the first step that is too long for the growth, 2 gamma h y > 1.
TEST(HardRuns, ARosenbrockMethodRemarksThatItStepsOverAPole) {
  const Case& c = find_case("blow_up");
  for (const char* solver : {"odeum/rosenbrock_euler", "odeum/ros2", "odeum/rodas4"}) {
    const Outcome past = find_entrant(c, solver).solve(fixed_request(100, {2}));
    EXPECT_NE(past.detail.find("too long for what grows"), std::string::npos)
        << solver << ": " << past.detail;
    const Outcome before = find_entrant(c, solver).solve(fixed_request(1000, {0.9}));
    EXPECT_EQ(before.status, Status::ok);
    EXPECT_EQ(before.detail, "") << solver;
    // A decay is never too fast.
    const Case& stiff = find_case("prothero_robinson_1e6_smooth");
    const Outcome decays = find_entrant(stiff, solver).solve(fixed_request(20, {10}));
    EXPECT_EQ(decays.detail, "") << solver;
  }
}

TEST(HardRuns, ImplicitMidpointSwingsAFreeClothAt60StepsASecond) {
  const Case& c = find_case("cloth11_two_way");
  const Outcome outcome =
      find_entrant(c, "odeum/implicit_midpoint").solve(fixed_request(120, {c.stops.back()}));
  EXPECT_EQ(outcome.status, Status::ok) << outcome.detail;
}

/// The last state of a built-in scene's run by implicit Euler, and its energy at the start and
/// there.
struct SceneEnd {
  Status status;
  std::string detail;
  double energy_before, energy_after;
};
SceneEnd run_to_end(const std::string& name, const char* method, double step) {
  for (const cases::SceneText& text : cases::all_scenes()) {
    if (text.name != name) continue;
    const scene::Scene scene = scene::read_scene(name, std::string(text.text)).scene;
    scene::RunSetting setting;
    setting.until = *scene.duration;
    setting.steps = static_cast<std::uint64_t>(std::lround(setting.until / step));
    setting.frame_interval = setting.until / 10;
    const scene::RunResult result = scene::run_scene(
        scene, setting,
        [&](const std::shared_ptr<const scene::SceneProblem>& problem, const Request& request) {
          for (const Entrant& entrant : cases::enroll_scene(problem))
            if (entrant.info.id() == method) return entrant.solve(request);
          throw std::invalid_argument(method);
        });
    const auto energy = [](const scene::Frame& f) { return f.kinetic + f.potential; };
    return {result.status, result.detail, energy(result.frames.front()),
            energy(result.frames.back())};
  }
  throw std::invalid_argument(name);
}

// Compressed links make Newton's matrix indefinite: it ended at t = 0.1, and its corrections lead
// to where the matrix is singular. Steps with a bound of the stiffness get past that.
TEST(HardRuns, ImplicitEulerSwingsAStiffRope) {
  for (const double step : {1.0 / 60, 0.01, 0.005}) {
    const SceneEnd end = run_to_end("stiff_rope", "odeum/implicit_euler", step);
    EXPECT_EQ(end.status, Status::ok) << step << ' ' << end.detail;
    EXPECT_LT(end.energy_after, end.energy_before) << "the method damps";
  }
}

}  // namespace
}  // namespace odeum::tests::hard_runs_test
