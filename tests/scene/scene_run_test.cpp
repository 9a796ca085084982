// SPDX-License-Identifier: BSD-3-Clause
// Complete runs of scenes against closed forms and conservation laws.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/scene_case.hpp"
#include "odeum/scene/read/reader.hpp"
#include "odeum/scene/run/run.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/trajectories/scene_files.hpp"
#include "support/scene_texts.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::scene_run_test {
namespace {

using scene::RunResult;
using scene::Scene;
using scene::Vec3;

const cases::SceneText& built_in(const std::string& name) {
  for (const cases::SceneText& text : cases::all_scenes())
    if (text.name == name) return text;
  throw std::invalid_argument(name);
}

Scene read(const std::string& text) { return scene::read_scene("s.yaml", text).scene; }
Scene built_in_scene(const std::string& name) { return read(std::string(built_in(name).text)); }

RunResult run(const Scene& scene, std::uint64_t steps, const std::string& method, double until = 0,
              double interval = 0) {
  scene::RunSetting setting;
  setting.steps = steps;
  setting.until = until > 0 ? until : *scene.duration;
  setting.frame_interval = interval > 0 ? interval : setting.until / 20;
  return scene::run_scene(
      scene, setting,
      [&](const std::shared_ptr<const scene::SceneProblem>& problem, const Request& request) {
        for (const Entrant& entrant : cases::enroll_scene(problem))
          if (entrant.info.id() == "odeum/" + method) return entrant.solve(request);
        throw std::invalid_argument(method);
      });
}

double total(const scene::Frame& frame) { return frame.kinetic + frame.potential; }

// The midpoint rule is exact where the acceleration is constant; 1000 steps round 1000 times.
TEST(SceneRun, AFreeParticleFallsAsInTheTextbook) {
  const Scene d = read(
      "duration: 2\nsolver: {type: midpoint, timestep: 0.002}\n"
      "particles: [{pos: [1, 2, 3], vel: [0.5, -1, 4], mass: 3}]\n");
  const RunResult result = run(d, 1000, "midpoint");
  ASSERT_EQ(result.status, Status::ok);
  EXPECT_EQ(result.frames.size(), 21U);
  const auto& y = result.frames.back().y;
  EXPECT_NEAR(y[0], 2, 1e-12);
  EXPECT_NEAR(y[1], 0, 1e-12);
  EXPECT_NEAR(y[2], 3 + 8 - 9.81 * 2, 1e-11);
  EXPECT_NEAR(y[5], 4 - 9.81 * 2, 1e-11);
  const RunResult exact = run(d, 1, "closed_form");
  EXPECT_NEAR(exact.frames.back().y[2], y[2], 1e-11);
  EXPECT_EQ(exact.counters.rhs_evaluations, 0U);
}

// Radius m v / (q B) about (0, y0); RK4 at 600 steps of 0.02 rad/0.5: error (w h)^5 / 120 a step.
TEST(SceneRun, AChargeCirclesInAField) {
  const RunResult result = run(built_in_scene("magnetic_helix"), 600, "rk4");
  ASSERT_EQ(result.status, Status::ok);
  const double radius = 0.5, omega = 2;
  for (const scene::Frame& frame : result.frames) {
    EXPECT_NEAR(std::hypot(frame.y[0], frame.y[1]), radius, 1e-5);
    EXPECT_NEAR(frame.y[0], radius * std::cos(omega * frame.t), 1e-4) << frame.t;
    EXPECT_NEAR(frame.y[1], -radius * std::sin(omega * frame.t), 1e-4) << frame.t;
    EXPECT_NEAR(frame.y[2], -1.2 + 0.2 * frame.t, 1e-12);
  }
}

// v = v_end tanh(g t / v_end): RK4 at g h / v_end = 0.007, far below 1e-8 in all.
TEST(SceneRun, ADropReachesItsTerminalVelocity) {
  const RunResult result = run(built_in_scene("raindrop"), 1000, "rk4");
  const double end = std::sqrt(0.001 * 9.81 / 0.0002);
  for (const scene::Frame& frame : result.frames)
    EXPECT_NEAR(-frame.y[5], end * std::tanh(9.81 * frame.t / end), 1e-8);
  EXPECT_NEAR(-result.frames.back().y[5], end, 2e-5) << "2 v e^(-2 g t / v) is left";
}

// w h = 0.1. Explicit Euler multiplies the energy by 1 + (w h)^2 each step, exactly, until the mass
// swings through the wall; symplectic Euler keeps it within w h / 2, and midpoint gains (w h)^4 / 4
// a step: 1 % in 400.
TEST(SceneRun, OneSpringUnderThreeMethods) {
  const auto worst = [](const std::string& method, std::uint64_t steps) {
    const RunResult result =
        run(built_in_scene("spring_" + method), steps, method, 0.05 * static_cast<double>(steps));
    double most = 0;
    for (const scene::Frame& frame : result.frames)
      most = std::max(most, std::abs(total(frame) / total(result.frames.front()) - 1));
    return most;
  };
  EXPECT_NEAR(worst("explicit_euler", 100) / (std::pow(1.01, 100) - 1), 1, 1e-9);
  EXPECT_LT(worst("symplectic_euler", 400), 0.06);
  EXPECT_GT(worst("symplectic_euler", 400), 0.005);
  EXPECT_NEAR(worst("midpoint", 400), 0.01, 0.001);
}

// The pair vibrates at w h = 0.08, where RK4 loses (w h)^6 / 72 of that energy a step: 7e-6 in
// 2000. Momentum is kept by every Runge-Kutta method. Verlet keeps the energy of the chain to
// O(h^2).
TEST(SceneRun, UndampedScenesKeepEnergyAndMomentum) {
  const RunResult pair = run(built_in_scene("spinning_pair"), 2000, "rk4");
  for (const scene::Frame& frame : pair.frames) {
    EXPECT_NEAR(total(frame), total(pair.frames.front()), 1e-5 * total(pair.frames.front()));
    for (const double component : frame.momentum) EXPECT_NEAR(component, 0, 1e-12);
    EXPECT_NEAR(frame.angular_momentum[2], pair.frames.front().angular_momentum[2], 1e-4);
  }
  const RunResult coarse = run(built_in_scene("chain"), 1000, "velocity_verlet", 0.5);
  const RunResult fine = run(built_in_scene("chain"), 2000, "velocity_verlet", 0.5);
  const auto worst = [](const RunResult& result) {
    double most = 0;
    for (const scene::Frame& frame : result.frames)
      most = std::max(most, std::abs(total(frame) - total(result.frames.front())));
    return most;
  };
  EXPECT_NEAR(worst(coarse) / worst(fine), 4, 1) << "order 2, seen at frames only";
}

TEST(SceneRun, ParticlesAreBornAndDie) {
  const Scene d = read(
      "gravity: 0\nduration: 1\nsolver: {type: midpoint, timestep: 0.01}\nemitters:\n"
      "  - {position: [1, 0, 0], velocity: [0, 0, 2], rate: 10, lifetime: 0.25, mass: 0.1}\n");
  const RunResult result = run(d, 100, "midpoint", 1, 0.01);
  ASSERT_EQ(result.status, Status::ok) << result.detail;
  EXPECT_EQ(result.births, 10U);
  EXPECT_EQ(result.deaths, 8U) << "those born by 0.7 are dead before 1";
  for (const scene::Frame& frame : result.frames)
    for (std::size_t i = 0; i < frame.ids.size(); ++i) {
      const double age = frame.t - 0.1 * static_cast<double>(frame.ids[i]);
      EXPECT_NEAR(frame.y[3 * i + 2], 2 * age, 1e-12);
      EXPECT_LE(age, 0.25 + 1e-9);
    }
  EXPECT_EQ(result.frames[50].ids, (std::vector<std::size_t>{3, 4})) << "0.3 + 0.25 > 0.5 > 0.45";
}

TEST(SceneRun, EmissionIsTheSameForTheSameSeed) {
  const Scene d = built_in_scene("fountain");
  const auto first = scene::emitted_particles(d.emitters, 2),
             again = scene::emitted_particles(d.emitters, 2);
  ASSERT_EQ(first.size(), 200U);
  Vec3 mean{};
  for (std::size_t k = 0; k < first.size(); ++k) {
    const Vec3& v = first[k].particle.velocity;
    EXPECT_EQ(v, again[k].particle.velocity);
    EXPECT_NEAR(std::hypot(v[0], v[1], v[2]), 6, 1e-12);
    EXPECT_GE(v[2], 6 * std::cos(0.25) - 1e-12);
    for (std::size_t i = 0; i < 3; ++i) mean[i] += v[i] / 200;
  }
  // Sideways components have a deviation of 6 * 0.25 / 2; of their mean, a fourteenth: 4 sigma.
  EXPECT_NEAR(mean[0], 0, 0.22);
  EXPECT_NEAR(mean[1], 0, 0.22);
  Scene other = d;
  other.emitters[0].seed = 2;
  EXPECT_NE(scene::emitted_particles(other.emitters, 1)[0].particle.velocity,
            first[0].particle.velocity);
}

// The fountain by an exact method and by midpoint, which is exact for it as well.
TEST(SceneRun, TheFountainAgreesWithItsClosedForm) {
  const Scene d = built_in_scene("fountain");
  const RunResult stepped = run(d, 100, "midpoint", 1), exact = run(d, 100, "closed_form", 1);
  ASSERT_EQ(stepped.frames.back().y.size(), exact.frames.back().y.size());
  for (std::size_t i = 0; i < exact.frames.back().y.size(); ++i)
    EXPECT_NEAR(stepped.frames.back().y[i], exact.frames.back().y[i], 1e-11);
}

TEST(SceneRun, AFailureKeepsWhatWasReached) {
  const RunResult result = run(built_in_scene("stiff_rope"), 600, "rk4");
  EXPECT_EQ(result.status, Status::non_finite);
  EXPECT_LT(result.t, 6);
  EXPECT_GE(result.frames.size(), 1U);
}

// Each with the settings of its file, as by `odeum run NAME`; a name shared with a case could not
// be run.
TEST(SceneRun, EveryBuiltInSceneRuns) {
  for (const cases::SceneText& text : cases::all_scenes()) {
    for (const Case& c : all_cases()) EXPECT_NE(c.id, text.name);
    const Scene d = read(std::string(text.text));
    if (d.solver->tolerance) continue;  // ADropReachesItsTerminalVelocity
    const double until = std::min(*d.duration, 0.2);
    const auto steps = static_cast<std::uint64_t>(std::ceil(until / *d.solver->step));
    const RunResult result = run(d, steps, d.solver->type, until);
    EXPECT_EQ(result.status, Status::ok) << text.name << ": " << result.detail;
  }
}

TEST(SceneRun, MethodsThatDoNotFitSayWhy) {
  const auto damped = std::make_shared<const scene::SceneProblem>(built_in_scene("jelly_cube"));
  std::size_t unfit = 0;
  for (const Entrant& entrant : cases::enroll_scene(damped))
    if (!entrant.unfit.empty()) {
      ++unfit;
      EXPECT_FALSE(entrant.solve) << entrant.info.id();
    } else {
      EXPECT_NE(entrant.info.method, "leapfrog");
    }
  EXPECT_GE(unfit, 3U);
}

TEST(SceneFiles, HaveTheColumnsOfTheFormat) {
  const RunResult result = run(read(tests::two_particles), 10, "rk4");
  EXPECT_TRUE(
      trajectories::final_csv(result).starts_with("schema,particle,x,y,z,vx,vy,vz\n1,0,0,0,0,0"));
  EXPECT_TRUE(trajectories::trajectory_csv(result).starts_with(
      "schema,time,particle,x,y,z,vx,vy,vz\n1,0,0,0,0,0,0,0,0\n1,0,1,1,0,0,0,0,0\n"));
  EXPECT_TRUE(trajectories::energy_csv(result).starts_with(
      "schema,time,kinetic,potential,total,momentum_x,momentum_y,momentum_z\n1,0,0,0,0,0,0,0\n"));
}

TEST(SceneFiles, ParaViewFindsItsSeries) {
  const tests::TemporaryFolder folder;
  const Scene d = built_in_scene("spinning_pair");
  trajectories::write_vtk_series(record::OutputFolder(folder.path()), d, run(d, 100, "rk4"), "", 5);
  const auto series =
      nlohmann::json::parse(tests::text_of(folder.path() / "trajectory.vtk.series"));
  ASSERT_EQ(series["files"].size(), 5U);
  const std::string text =
      tests::text_of(folder.path() / series["files"][0]["name"].get<std::string>());
  EXPECT_TRUE(text.starts_with("# vtk DataFile Version 3.0\nOdeum: spinning pair\nASCII\n"));
  EXPECT_NE(text.find("POINTS 2 float\n-0.5 0 0\n0.5 0 0\n"), std::string::npos);
  EXPECT_NE(text.find("LINES 1 3\n2 0 1\n"), std::string::npos);
}

// A name must not end the script element, and nothing may be loaded from elsewhere.
TEST(SceneFiles, TheReplayPageHoldsItself) {
  Scene d = built_in_scene("spinning_pair");
  d.name = "</script><b>&<!--data-->";
  const std::string page = trajectories::replay_page(d, run(d, 100, "rk4"), {"fact <1>"});
  EXPECT_EQ(page.find("</script><b>"), std::string::npos);
  EXPECT_NE(page.find("\\u003c/script>"), std::string::npos);
  EXPECT_NE(page.find("fact \\u003c1>"), std::string::npos);
  EXPECT_EQ(page.find("http://"), std::string::npos);
  EXPECT_EQ(page.find("https://"), std::string::npos);
  EXPECT_EQ(page.find("eval("), std::string::npos);
  EXPECT_EQ(page.find("<!--"), std::string::npos) << "every part is filled in";
}

}  // namespace
}  // namespace odeum::scene_run_test
