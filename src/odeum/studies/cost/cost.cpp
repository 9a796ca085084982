// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/cost/cost.hpp"

#include <chrono>
#include <cmath>
#include <functional>

#include "odeum/cases/square_cloth.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/core/progress.hpp"
#include "odeum/studies/cost/cloth_lanes.hpp"
#include "odeum/studies/scene_stage.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::study {
namespace {

using Clock = std::chrono::steady_clock;

struct Turns {
  std::vector<Times> times;  ///< by rival
  Conditions conditions;
};

/// Interleaved runs of all, at least three times and for `seconds` each on average.
Turns take_turns(const std::vector<std::function<void()>>& rivals, double seconds) {
  const Pinned pinned;
  const ConditionsMeter meter;
  std::vector<Times> times(rivals.size());
  const auto start = Clock::now();
  const double all = seconds * static_cast<double>(rivals.size());
  for (int round = 0;
       round < 3 || std::chrono::duration<double>(Clock::now() - start).count() < all; ++round)
    for (std::size_t i = 0; i < rivals.size(); ++i) {
      if (interrupted) throw Interrupted();
      times[i].ns.push_back(time_call(rivals[i], 1e9));
    }
  return {std::move(times), meter.end()};
}

constexpr double watched_for = timed_cloth_time;
constexpr double damping = 0.05;  // of square_cloth, N s/m

/// Whether velocity Verlet keeps q'' = -w^2 q - c q' bounded. The acceleration at the predicted
/// velocity v + h a is used in the next step too, so that its map has three unknowns: q, h v, h^2
/// a.
bool verlet_bounded(double h, double w, double c) {
  const double x = h * h * w * w, y = h * c;
  double q = 1, u = 1, a = 1;
  for (int i = 0; i < 1000 && std::abs(q) < 1e6; ++i) {
    const double predicted = u + a;
    q += u + a / 2;
    const double next = -x * q - y * predicted;
    u += (a + next) / 2;
    a = next;
  }
  return std::abs(q) < 1e6;
}

/// Largest stable step less a margin. At what springs alone allow w h = 2, at what dampers
/// alone allow Verlet c h = 1, by the map above. It has both in one mode at worst.
double stable_step(double mass, double stiffness, bool damping_limits) {
  const double by_springs = cloth_spring_limit * std::sqrt(mass / stiffness),
               by_damping = cloth_damping_limit * mass / damping;
  double h = by_springs;
  if (damping_limits)
    while (!verlet_bounded(h, 2 / by_springs, 1 / by_damping)) h *= 0.99;
  return timed_cloth_margin * h;
}

struct Reference {
  std::vector<double> y;
  double left;  ///< distance of the two runs that it comes from, m
};

/// There is no independent truth at this size: RK4 at what is stable for Verlet, and at half of it.
Reference rk4_reference(const scene::Scene& scene, double stiffness) {
  const double h = stable_step(scene.particles[0].mass, stiffness, true);
  const auto run = [&](double parts) {
    const auto cloth = rk4_steps(scene);
    const auto steps = static_cast<std::uint64_t>(std::ceil(parts * watched_for / h));
    cloth->run(watched_for / static_cast<double>(steps), steps);
    return cloth->state();
  };
  std::vector<double> fine = run(2);
  const double left = rms_distance(fine, run(1), scene.size());
  return {std::move(fine), left};
}

/// A method at a step.
struct Rival {
  const char* name;
  double frame;  ///< s; NaN for the largest stable step
  double h;      ///< s
  /// Fills y with the state at `watched_for`; false where a step fails.
  std::function<bool(double h, std::uint64_t steps, std::vector<double>& y)> run;
  std::vector<double> y{};
  bool solved = true;

  void go() { solved = run(h, static_cast<std::uint64_t>(std::lround(watched_for / h)), y); }
};

std::vector<Rival> rivals_on(const scene::Scene& scene, double stiffness,
                             const std::vector<double>& frames) {
  const double mass = scene.particles[0].mass;
  const auto step = [&](bool damping_limits) {
    return watched_for / std::ceil(watched_for / stable_step(mass, stiffness, damping_limits));
  };
  const auto by = [](auto make) {
    return [make](double h, std::uint64_t steps, std::vector<double>& y) {
      const auto cloth = make();
      const bool solved = cloth->run(h, steps);
      y = cloth->state();
      return solved;
    };
  };
  std::vector<Rival> rivals;
  rivals.push_back({"verlet_f32", nan, step(true),
                    by([&scene] { return velocity_verlet_steps<float>(scene); })});
  rivals.push_back({"imex_f32", nan, step(false),
                    by([&scene] { return imex_verlet_steps(scene, timed_cloth_residual); })});
  for (const double frame : frames)
    rivals.push_back({"implicit_f64", frame, frame, by([&scene] {
                        return predicted_implicit_euler_steps(scene, timed_cloth_residual);
                      })});
  return rivals;
}

}  // namespace

std::vector<ClothCostRow> measure_cloth_cost(const std::vector<std::size_t>& sides,
                                             double seconds_each) {
  std::vector<ClothCostRow> rows;
  Progress progress("cloth cost", static_cast<double>(sides.size()));
  for (const std::size_t n : sides) {
    const scene::Scene scene = cases::square_cloth(n, 10);
    const auto f64 = velocity_verlet_steps<double>(scene);
    const auto f32 = velocity_verlet_steps<float>(scene);
    // Some 5 ms a call; a step so short that nothing moves far.
    const std::size_t steps = 300'000 / (n * n) + 2;
    const auto [times, conditions] =
        take_turns({[&] { f64->run(1e-6, steps); }, [&] { f32->run(1e-6, steps); }}, seconds_each);
    const auto each = static_cast<double>(steps * n * n);
    for (const auto& [name, time] : {std::pair{"f64", times[0]}, {"f32", times[1]}})
      rows.push_back({time.columns(each), n, name, conditions});
    progress.advance();
  }
  return rows;
}

std::vector<ImplicitWinsRow> measure_implicit_wins(std::size_t side,
                                                   const std::vector<double>& stiffnesses,
                                                   const std::vector<double>& frames,
                                                   double seconds_each) {
  std::vector<ImplicitWinsRow> rows;
  Progress progress("implicit", static_cast<double>(stiffnesses.size()));
  for (const double stiffness : stiffnesses) {
    const scene::Scene scene = cases::square_cloth(side, stiffness);
    const Reference reference = rk4_reference(scene, stiffness);
    std::vector<Rival> rivals = rivals_on(scene, stiffness, frames);
    std::vector<std::function<void()>> calls;
    calls.reserve(rivals.size());
    for (Rival& rival : rivals) calls.emplace_back([&rival] { rival.go(); });
    const auto [times, conditions] = take_turns(calls, seconds_each);
    for (std::size_t i = 0; i < rivals.size(); ++i) {
      const Rival& rival = rivals[i];
      const double distance = rms_distance(rival.y, reference.y, scene.size());
      ImplicitWinsRow row;
      static_cast<WallTimes&>(row) = times[i].columns(watched_for);
      row.stiffness = stiffness;
      row.frame = rival.frame;
      row.engine = rival.name;
      row.status = !rival.solved ? "newton_failed" : std::isfinite(distance) ? "ok" : "non_finite";
      if (!rival.solved) row.detail = "conjugate gradients did not converge";
      row.step = rival.h;
      if (row.status == "ok") row.rk4_distance = distance;
      row.rk4_left = reference.left;
      row.conditions = conditions;
      rows.push_back(std::move(row));
    }
    progress.advance();
  }
  return rows;
}

}  // namespace odeum::study
