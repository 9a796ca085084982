// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>

#include "odeum/harness/parallel.hpp"
#include "odeum/harness/progress.hpp"
#include "odeum/scene/cloth_engine.hpp"
#include "odeum/scene/imex_cloth.hpp"
#include "odeum/scene/implicit_cloth.hpp"
#include "odeum/study/material.hpp"
#include "odeum/study/stopwatch.hpp"
#include "support/square_cloth.hpp"

namespace odeum::study {
namespace {

using Clock = std::chrono::steady_clock;

/// Watches the machine while times are taken, as the study of precision does.
class Watch {
 public:
  Conditions end() const {
    const double wall = std::chrono::duration<double>(Clock::now() - start_).count();
    return {.drift = calibration_ns() / before_ - 1,
            .processor_share = (thread_seconds() - used_) / wall,
            .measured = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)))};
  }

 private:
  double before_ = calibration_ns(), used_ = thread_seconds();
  Clock::time_point start_ = Clock::now();
};

/// Runs all in turns, three times at least and for `seconds` each on average.
std::vector<Times> take_turns(const std::vector<std::function<void()>>& rivals, double seconds) {
  std::vector<Times> times(rivals.size());
  const auto start = Clock::now();
  const double all = seconds * static_cast<double>(rivals.size());
  for (int round = 0;
       round < 3 || std::chrono::duration<double>(Clock::now() - start).count() < all; ++round)
    for (std::size_t i = 0; i < rivals.size(); ++i) {
      if (interrupted) throw Interrupted();
      const auto begin = Clock::now();
      rivals[i]();
      times[i].ns.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count());
    }
  return times;
}

constexpr double watched_for = 8.0 / 30;  // s; a whole number of every frame
constexpr double damping = 0.05;          // of square_cloth, N s/m

/// The largest steps that are stable, measured (ImexCloth); a tenth is kept clear of them.
double stable_step(double mass, double stiffness, bool damping_limits) {
  const double by_springs = 0.566 * std::sqrt(mass / stiffness),
               by_damping = 0.092 * mass / damping;
  return 0.9 * (damping_limits ? std::min(by_springs, by_damping) : by_springs);
}

template <class Engine>
std::vector<double> state_of(const Engine& engine, std::size_t particles) {
  std::vector<double> y(6 * particles);
  engine.read(y.data());
  return y;
}

struct Truth {
  std::vector<double> y;
  double left;  ///< distance of the two runs that it comes from, m
};

/// By RK4 at half of what is stable for Verlet, and at a quarter.
Truth find_truth(const scene::Scene& scene, double stiffness) {
  const double h = stable_step(scene.particles[0].mass, stiffness, true);
  const auto run = [&](double parts) {
    scene::ClothEngine<double> engine(scene);
    const auto steps = static_cast<std::size_t>(std::ceil(parts * watched_for / h));
    engine.rk4(watched_for / static_cast<double>(steps), steps);
    return state_of(engine, scene.size());
  };
  std::vector<double> fine = run(4);
  const double left = rms_distance(fine, run(2), scene.size());
  return {std::move(fine), left};
}

}  // namespace

std::vector<ClothCostRow> measure_cloth_cost(const std::vector<std::size_t>& sides,
                                             double seconds_each) {
  std::vector<ClothCostRow> rows;
  Progress progress("cloth cost", static_cast<double>(sides.size()));
  for (const std::size_t n : sides) {
    const scene::Scene scene = cases::square_cloth(n, 10);
    scene::ClothEngine<double> f64(scene);
    scene::ClothEngine<float> f32(scene);
    // Some 5 ms a call; a step so short that nothing moves far.
    const std::size_t steps = 300'000 / (n * n) + 2;
    const Pinned pinned;
    const Watch watch;
    const auto times = take_turns(
        {[&] { f64.velocity_verlet(1e-6, steps); }, [&] { f32.velocity_verlet(1e-6, steps); }},
        seconds_each);
    const Conditions conditions = watch.end();
    const double each = static_cast<double>(steps * n * n);
    for (const auto& [name, time] : {std::pair{"f64", times[0]}, {"f32", times[1]}})
      rows.push_back({.side = n,
                      .precision = name,
                      .wall_ns_min = time.min() / each,
                      .wall_ns_median = time.median() / each,
                      .repetitions = time.ns.size(),
                      .conditions = conditions});
    progress.advance();
  }
  return rows;
}

std::vector<ImplicitWinsRow> measure_implicit_wins(std::size_t side,
                                                   const std::vector<double>& stiffnesses,
                                                   const std::vector<double>& frames,
                                                   double seconds_each) {
  std::vector<ImplicitWinsRow> rows;
  Progress progress("implicit", static_cast<double>(stiffnesses.size() * frames.size()));
  for (const double stiffness : stiffnesses) {
    const scene::Scene scene = cases::square_cloth(side, stiffness);
    const double mass = scene.particles[0].mass;
    const Truth truth = find_truth(scene, stiffness);
    for (const double frame : frames) {
      // A whole number of steps a frame, as few as are stable.
      const auto frames_in_all = static_cast<std::size_t>(std::lround(watched_for / frame));
      const auto parts = [&](bool damping_limits) {
        return static_cast<std::size_t>(
            std::ceil(frame / stable_step(mass, stiffness, damping_limits)));
      };
      struct Rival {
        const char* name;
        std::size_t parts;
        std::function<bool(double h, std::size_t steps, std::vector<double>& y)> run;
        std::vector<double> y;
        bool solved = true;
      };
      Rival rivals[] = {{"verlet_f32",
                         parts(true),
                         [&](double h, std::size_t steps, std::vector<double>& y) {
                           scene::ClothEngine<float> engine(scene);
                           engine.velocity_verlet(h, steps);
                           y = state_of(engine, scene.size());
                           return true;
                         },
                         {}},
                        {"imex_f32",
                         parts(false),
                         [&](double h, std::size_t steps, std::vector<double>& y) {
                           scene::ImexCloth<float> engine(scene);
                           engine.step(h, steps, 1e-2);
                           y = state_of(engine, scene.size());
                           return true;
                         },
                         {}},
                        {"implicit_f64",
                         1,
                         [&](double h, std::size_t steps, std::vector<double>& y) {
                           scene::ImplicitCloth engine(scene);
                           const bool solved = engine.step(h, steps, 1e-2);
                           y = state_of(engine, scene.size());
                           return solved;
                         },
                         {}}};
      std::vector<std::function<void()>> calls;
      for (Rival& rival : rivals)
        calls.emplace_back([&, h = frame / static_cast<double>(rival.parts)] {
          rival.solved = rival.run(h, frames_in_all * rival.parts, rival.y);
        });
      const Pinned pinned;
      const Watch watch;
      const auto times = take_turns(calls, seconds_each);
      const Conditions conditions = watch.end();
      for (std::size_t i = 0; i < std::size(rivals); ++i) {
        const Rival& rival = rivals[i];
        const double error = rms_distance(rival.y, truth.y, scene.size());
        ImplicitWinsRow row;
        row.stiffness = stiffness;
        row.frame = frame;
        row.engine = rival.name;
        row.status = !rival.solved ? "newton_failed" : std::isfinite(error) ? "ok" : "non_finite";
        if (!rival.solved) row.detail = "conjugate gradients did not end";
        row.step = frame / static_cast<double>(rival.parts);
        row.wall_ns_min = times[i].min() / watched_for;
        row.wall_ns_median = times[i].median() / watched_for;
        row.repetitions = times[i].ns.size();
        if (row.status == "ok") row.error = error;
        row.truth_left = truth.left;
        row.conditions = conditions;
        rows.push_back(std::move(row));
      }
      progress.advance();
    }
  }
  return rows;
}

}  // namespace odeum::study
