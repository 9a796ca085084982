// SPDX-License-Identifier: BSD-3-Clause
// Time to reach an error on a cloth. Errors are RMS distances of positions from a truth that two
// own high-order methods agree on (see ClothStage::truth).
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "cloth_stage.hpp"
#include "goals.hpp"
#include "odeum/studies/material/cloth_steps.hpp"

namespace odeum::bench {
namespace {

/// The state after n steps that together take t seconds.
std::vector<double> after(const auto& cloth, double t, double n) {
  if (!cloth->run(t / n, static_cast<std::uint64_t>(n))) throw std::runtime_error("a failed step");
  return cloth->state();
}

/// An own implicit step against Bullet's, both one Newton step of backward Euler at the same h.
Row implicit_row(std::size_t n, double goal) {
  constexpr double h = 0.01, tolerance = 1e-2;
  const std::size_t steps = n > 32 ? 10 : 50;
  const double t = h * static_cast<double>(steps);
  const ClothStage stage(n, 10);
  const std::vector<double> truth = stage.truth(t);
  double own_error = 0, peer_error = 0;
  const auto time = interleave(
      {[&] {
         const auto cloth = study::predicted_implicit_euler_steps(stage.scene(), tolerance);
         own_error = stage.distance(after(cloth, t, static_cast<double>(steps)), truth);
       },
       [&] {
         peer_error = stage.distance(stage.fixed("bullet/deformable_implicit", t, steps), truth);
       }},
      3);
  return compare(fmt::format("{0} x {0}: Bullet deformable implicit / own, dt = 0.01", n), goal,
                 time[0], time[1],
                 fmt::format("errors {:.2g} (own, CG to {:.0e}) and {:.2g} m", own_error, tolerance,
                             peer_error));
}

/// The least time at which `run(setting)` reaches `error`, over settings from coarse to fine: on
/// the line between the two around it, in logarithms.
struct Reached {
  Timing time;
  std::string how;
};
template <class Run, class Error>
Reached reach(double error, const std::vector<double>& settings, Run&& run, Error&& error_of) {
  double last_error = 0;
  Timing last;
  for (const double setting : settings) {
    const double e = error_of(run(setting));
    if (!std::isfinite(e)) continue;  // beyond the stable step
    const Timing time = interleave({[&] { run(setting); }}, 0.5)[0];
    if (e <= error) {
      if (last_error == 0) return {time, fmt::format("{:.3g}", setting)};
      const double part = std::log(last_error / error) / std::log(last_error / e);
      const auto between = [&](double a, double b) {
        return std::exp((1 - part) * std::log(a) + part * std::log(b));
      };
      return {{between(last.min, time.min), between(last.median, time.median)},
              fmt::format("{:.3g}", setting)};
    }
    last_error = e;
    last = time;
  }
  throw std::runtime_error("nothing reached the error");
}

void equal_error_rows(std::vector<Row>& rows) {
  constexpr std::size_t n = 64;
  constexpr double t = 0.25;
  const ClothStage stage(n, 10);
  const std::vector<double> truth = stage.truth(t);
  const auto error_of = [&](const std::vector<double>& y) { return stage.distance(y, truth); };
  const auto verlet = [&](double steps) {
    return after(study::velocity_verlet_steps<float>(stage.scene()), t, steps);
  };
  const auto rk4 = [&](double steps) {
    return after(study::rk4_steps<double>(stage.scene()), t, steps);
  };
  const std::vector<double> step_counts{190, 220, 256, 320, 400, 512, 724, 1024, 2048};
  const Reached by_verlet = reach(1e-3, step_counts, verlet, error_of);
  const Reached by_rk4 = reach(1e-3, {70, 80, 90, 100, 128, 181, 256, 512}, rk4, error_of);
  const bool rk4_first = by_rk4.time.min < by_verlet.time.min;
  const Reached& own = rk4_first ? by_rk4 : by_verlet;

  // Bullet is of order 1 and cannot reach the error in reasonable time: its time is extrapolated
  // from the rate of its last halving.
  constexpr std::uint64_t coarse = 256;
  const double e1 = error_of(stage.fixed("bullet/deformable_explicit", t, coarse));
  double e2 = 0;
  const Timing bullet = interleave(
      {[&] { e2 = error_of(stage.fixed("bullet/deformable_explicit", t, 2 * coarse)); }}, 3)[0];
  const double more = e2 / 1e-3;
  rows.push_back(compare(
      "64 x 64: Bullet deformable explicit / best own, time to 1e-3", 100, own.time,
      {bullet.min * more, bullet.median * more},
      fmt::format(
          "own {} in {:.3g} ms; Bullet's errors {:.2g}, {:.2g} at {} and {} steps, then as 1/n",
          rk4_first ? "RK4 f64" : "velocity Verlet f32", 1e3 * own.time.min, e1, e2, coarse,
          2 * coarse)));

  const Reached own_4 = reach(4e-4, {70, 80, 90, 100, 128, 181, 256, 512}, rk4, error_of);
  const Reached own_4v = reach(4e-4, step_counts, verlet, error_of);
  const Reached& best = own_4.time.min < own_4v.time.min ? own_4 : own_4v;
  const ClothStage plain(n, 10, Forces::plain);
  const auto adams = [&](const ClothStage& on) {
    return reach(
        4e-4, {1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6},
        [&](double tolerance) { return on.adaptive("cvode/adams", t, tolerance); }, error_of);
  };
  const Reached by_plain = adams(plain), by_ours = adams(stage);
  rows.push_back(compare(
      "64 x 64: CVODE Adams on the plain loop / best own, time to 4e-4", 20, best.time,
      by_plain.time,
      fmt::format("{:.3g} ms against {:.3g} ms; {:.1f} where CVODE is given our forces",
                  1e3 * best.time.min, 1e3 * by_plain.time.min, by_ours.time.min / best.time.min)));
}

}  // namespace

std::vector<Row> cloth_error_rows() {
  std::vector<Row> rows;
  for (const auto& [n, goal] :
       {std::pair{std::size_t{11}, 12.0}, {std::size_t{32}, 20.0}, {std::size_t{64}, 25.0}})
    rows.push_back(implicit_row(n, goal));
  equal_error_rows(rows);
  return rows;
}

}  // namespace odeum::bench
