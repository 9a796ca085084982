// SPDX-License-Identifier: BSD-3-Clause
// The cost of a step of a cloth, of the forces and in total.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "cloth_stage.hpp"
#include "goals.hpp"
#include "grid_forces.hpp"
#include "odeum/cases/square_cloth.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/springs/lanes.hpp"
#include "odeum/studies/cost/cloth_lanes.hpp"

namespace odeum::bench {
namespace {

using cases::square_cloth;
using scene::Scene;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Vector instructions a second of a loop of independent fused multiply-adds.
template <class Real>
double peak_instructions() {
  using V = scene::Vector<Real>;
  constexpr int chains = 12, rounds = 2'000'000;
  volatile Real seed = Real(0.5);
  const auto spin = [&] {
    V x[chains];
    for (int k = 0; k < chains; ++k) x[k] = V{} + seed + static_cast<Real>(k);
    const V a = V{} + seed, b = V{} + seed;
    for (int i = 0; i < rounds; ++i)
      for (V& each : x) each = each * a + b;
    V sum{};
    for (const V& each : x) sum += each;
    seed = seed + sum[0] * Real(1e-30);
  };
  return static_cast<double>(chains) * rounds / interleave({spin}, 0.3)[0].min;
}

/// Arithmetic vector instructions of GridSprings::forces for a vector of springs, read off
/// spring_kernels_lanes.cpp: 3 differences, 3 for the squared length, 7 for 1/sqrt (5 in single
/// precision), 3 for the elastic force, 4 for the damping, 6 for the force, 6 for its sums at both
/// ends. A guess that is one of floats alone takes two conversions and a longer series.
template <class Real>
constexpr double instructions_a_spring =
    std::is_same_v<Real, double> ? 32 + 3 * scene::guessed_as_float : 30 + scene::guessed_as_float;

/// One frame at 60 a second, at the largest steps that are stable.
void add_frame_rows(std::vector<Row>& rows) {
  constexpr double frame = 1.0 / 60;
  // Threads are taken by wall time, which other programs lengthen.
  double load = 0;
  const bool busy = getloadavg(&load, 1) == 1 && load > 1.5;
  for (const auto& [n, threads, limit] : {std::tuple{std::size_t{128}, std::size_t{1}, 5.0},
                                          {std::size_t{256}, std::size_t{2}, 16.7}}) {
    const Scene scene = square_cloth(n, 10);
    const double m = scene.particles[0].mass;
    const double by_springs = study::cloth_spring_limit * std::sqrt(m / 10),
                 by_damping = 0.98 * study::cloth_damping_limit * m / 0.05;
    const auto steps_of = [](double largest) {
      return static_cast<std::size_t>(std::ceil(frame / largest));
    };
    const std::size_t many = steps_of(std::min(by_springs, by_damping)), few = steps_of(by_springs);
    const auto verlet = study::velocity_verlet_steps<float>(scene, threads);
    const auto imex = study::imex_verlet_steps(scene, 1e-2, threads);
    const auto t = interleave({[&] { verlet->run(frame / static_cast<double>(many), many); },
                               [&] { imex->run(frame / static_cast<double>(few), few); }},
                              2, false);
    const auto add = [&, n = n, threads = threads](const char* how, double goal, const Timing& time,
                                                   std::size_t steps) {
      rows.push_back(
          {.what = fmt::format("{0} x {0}: a frame at 60 a second, {1}, f32, {2} thread{3}", n, how,
                               threads, threads > 1 ? "s" : ""),
           .goal = goal,
           .measured = 1e3 * time.min,
           .low = 1e3 * time.min,
           .high = 1e3 * time.median,
           .at_most = true,
           .unit = " ms",
           .note = fmt::format("{} steps", steps),
           .disturbed = busy});
    };
    add("Verlet", nan, t[0], many);
    add("IMEX", limit, t[1], few);
  }
}

}  // namespace

std::vector<Row> cloth_kernel_rows() {
  std::vector<Row> rows;
  for (const std::size_t n : {std::size_t{11}, std::size_t{64}, std::size_t{256}}) {
    const Scene scene = square_cloth(n, 10);
    PlainCloth plain(scene);
    GridForces<double> grid(scene);
    GridForces<float> single(scene);
    const int times = static_cast<int>(4'000'000 / scene.springs.size()) + 1;
    const auto repeat = [times](auto& cloth) {
      return [&cloth, times] {
        for (int i = 0; i < times; ++i) cloth.forces();
      };
    };
    const auto t = interleave({repeat(plain), repeat(grid), repeat(single)}, 2);
    const double each =
        1e9 / static_cast<double>(times) / static_cast<double>(scene.springs.size());
    const bool goal = n == 64;
    rows.push_back(compare(
        fmt::format("{0} x {0}: plain loop / grid kernel, f64", n), goal ? by_vectors(3, 2.4) : nan,
        t[1], t[0], fmt::format("{:.2f} / {:.2f} ns a spring", each * t[0].min, each * t[1].min)));
    rows.push_back(compare(fmt::format("{0} x {0}: plain loop / grid kernel, f32", n),
                           goal ? by_vectors(7, 5.5) : nan, t[2], t[0],
                           fmt::format("{:.2f} ns a spring", each * t[2].min)));
    if (!goal) continue;
    const auto used = [&]<class Real>(const GridForces<Real>& forces, const Timing& time) {
      const double vectors = static_cast<double>(forces.layout.rows) *
                             std::ceil(static_cast<double>(n) / scene::Lanes<Real>::count);
      return 100 * vectors * 8 * instructions_a_spring<Real> * times / time.min /
             peak_instructions<Real>();
    };
    for (const auto& [name, share] :
         {std::pair{"f64", used(grid, t[1])}, {"f32", used(single, t[2])}})
      rows.push_back(
          {.what = fmt::format("{0} x {0}: share of the measured FMA rate, {1}", n, name),
           .goal = 55,
           .measured = share,
           .unit = " %",
           .note = "instructions of the kernel, read off its source"});
  }
  return rows;
}

std::vector<Row> cloth_step_rows() {
  std::vector<Row> rows;
  constexpr double h = 1.0 / 1024;
  const struct {
    std::size_t n;
    double goal;
    std::uint64_t bullet_steps, own_steps;
  } sizes[] = {{11, by_vectors(20, 14), 400, 20'000},
               {32, by_vectors(40, 26), 60, 2'000},
               {64, by_vectors(60, 45), 20, 500}};
  for (const auto& size : sizes) {
    const ClothStage stage(size.n, 10), plain(size.n, 10, Forces::plain);
    const auto verlet_steps = study::velocity_verlet_steps<double>(stage.scene());
    const auto rk4_steps = study::rk4_steps(stage.scene());
    // The difference of two runs of a peer removes its set-up: three quarters of it are steps
    // alone.
    const auto steps_of = [](const ClothStage& on, const std::string& id, std::uint64_t steps) {
      return [&on, id, steps] { on.fixed(id, h * static_cast<double>(steps), steps); };
    };
    const auto per_step = [](const Timing& whole, const Timing& quarter, std::uint64_t steps) {
      const double n = 0.75 * static_cast<double>(steps);
      return Timing{(whole.min - quarter.min) / n, (whole.median - quarter.median) / n};
    };
    const std::uint64_t b = size.bullet_steps, s = size.own_steps;
    const auto t = interleave(
        {[&] { verlet_steps->run(h / 64, s); }, steps_of(stage, "bullet/deformable_explicit", b),
         steps_of(stage, "bullet/deformable_explicit", b / 4),
         [&] { rk4_steps->run(h / 64, s / 4); }, steps_of(stage, "odeint/runge_kutta4", s / 4),
         steps_of(stage, "odeint/runge_kutta4", s / 16),
         steps_of(plain, "odeint/runge_kutta4", s / 4),
         steps_of(plain, "odeint/runge_kutta4", s / 16)},
        3);
    const auto scaled = [](const Timing& x, double by) {
      return Timing{x.min / by, x.median / by};
    };
    const Timing verlet = scaled(t[0], static_cast<double>(s)),
                 rk4 = scaled(t[3], static_cast<double>(s) / 4);
    rows.push_back(compare(
        fmt::format("{0} x {0}: Bullet deformable explicit / velocity Verlet, a step", size.n),
        size.goal, verlet, per_step(t[1], t[2], b), fmt::format("{:.3g} us", 1e6 * verlet.min)));
    rows.push_back(
        compare(fmt::format("{0} x {0}: odeint rk4 on the plain loop / RK4, a step", size.n),
                size.n == 64 ? 4 : nan, rk4, per_step(t[6], t[7], s / 4),
                fmt::format("{:.3g} us; {:.2f} where odeint is given our forces", 1e6 * rk4.min,
                            per_step(t[4], t[5], s / 4).min / rk4.min)));
  }
  add_frame_rows(rows);
  for (const std::size_t n : {11, 32, 64, 128, 256, 512}) {
    const auto cloth = study::velocity_verlet_steps<double>(square_cloth(n, 10));
    const std::size_t steps = 2'000'000 / (n * n) + 2;
    const auto t = interleave({[&] { cloth->run(1e-6, steps); }}, 0.5);
    rows.push_back({.what = fmt::format("{0} x {0}: velocity Verlet, f64, a particle and step", n),
                    .goal = nan,
                    .measured = 1e9 * t[0].min / static_cast<double>(steps * n * n),
                    .unit = " ns"});
  }
  return rows;
}

}  // namespace odeum::bench
