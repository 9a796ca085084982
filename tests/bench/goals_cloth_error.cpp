// SPDX-License-Identifier: BSD-3-Clause
// Time to reach an error on a cloth. Errors are RMS distances of positions from a truth that two
// own high-order methods agree on (see ClothStage::truth).
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "cloth_stage.hpp"
#include "goals.hpp"
#include "odeum/studies/cost/cloth_lanes.hpp"

namespace odeum::bench {
namespace {

/// The state after n steps that together take t seconds.
std::vector<double> after(const auto& cloth, double t, double n) {
  if (!cloth->run(t / n, static_cast<std::uint64_t>(n))) throw std::runtime_error("a failed step");
  return cloth->state();
}

/// One of Bullet's methods with options.
struct BulletRun {
  std::string id;
  Variant options = {};
  double error = 0;
  std::string text() const {
    std::string text = id.substr(id.find('/') + 1);
    for (const auto& [name, value] : options) text += fmt::format(" {}={:g}", name, value);
    return text;
  }
};

/// With the library's defaults, and as its users tune it.
std::vector<BulletRun> tuned(const std::string& id) {
  std::vector<BulletRun> runs{{id}};
  for (const Variant& variant : variants_of(id)) runs.push_back({id, variant});
  return runs;
}

/// An own implicit step against Bullet's at the same h: one Newton step of backward Euler, and of
/// Bullet's variants the fastest that loses no accuracy.
Row implicit_row(std::size_t n, double goal) {
  constexpr double h = 0.01, tolerance = 1e-2, same_error = 1.02;
  const std::size_t steps = n > 32 ? 10 : 50;
  const double t = h * static_cast<double>(steps);
  const ClothStage stage(n, 10);
  const std::vector<double> truth = stage.truth(t);
  double own_error = 0;
  std::vector<BulletRun> bullet = tuned("bullet/deformable_implicit");
  std::vector<std::function<void()>> runs{[&] {
    const auto cloth = study::predicted_implicit_euler_steps(stage.scene(), tolerance);
    own_error = stage.distance(after(cloth, t, static_cast<double>(steps)), truth);
  }};
  for (BulletRun& run : bullet)
    runs.emplace_back(
        [&] { run.error = stage.distance(stage.fixed(run.id, t, steps, run.options), truth); });
  const std::vector<Timing> time = interleave(runs, 5);
  std::size_t best = 0;
  for (std::size_t i = 1; i < bullet.size(); ++i)
    if (bullet[i].error <= same_error * bullet[0].error && time[i + 1].min < time[best + 1].min)
      best = i;
  return compare(fmt::format("{0} x {0}: Bullet deformable implicit / own, dt = 0.01", n), goal,
                 time[0], time[best + 1],
                 fmt::format("errors {:.2g} (own, CG to {:.0e}) and {:.2g} m ({})", own_error,
                             tolerance, bullet[best].error, bullet[best].text()));
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

/// The time of a method of order 1 to an error of 1e-3, which none of Bullet's reaches in
/// reasonable time: extrapolated from the rate of its last halving, for the one of `runs` that a
/// coarse run promises the most for.
struct Extrapolated {
  Timing time;
  std::string how;
};
Extrapolated time_to_error(const ClothStage& stage, double t, const auto& error_of,
                           std::vector<BulletRun> runs) {
  constexpr std::uint64_t coarse = 256;
  double least = std::numeric_limits<double>::infinity();
  BulletRun best;
  for (BulletRun& run : runs) {
    const Timing once = interleave(
        {[&] { run.error = error_of(stage.fixed(run.id, t, coarse, run.options)); }}, 0)[0];
    if (const double work = once.min * run.error; work < least) least = work, best = run;
  }
  double e2 = 0;
  const Timing time =
      interleave({[&] { e2 = error_of(stage.fixed(best.id, t, 2 * coarse, best.options)); }}, 3)[0];
  const double more = e2 / 1e-3;
  return {{time.min * more, time.median * more},
          fmt::format("{}: errors {:.2g}, {:.2g} at {} and {} steps, then as 1/n", best.text(),
                      best.error, e2, coarse, 2 * coarse)};
}

/// Bullet's deformable bodies, explicit and implicit; beside it its soft bodies, whose forces are
/// given to them.
Row bullet_row(const ClothStage& stage, double t, const auto& error_of, const Reached& own,
               const char* own_name) {
  std::vector<BulletRun> deformable = tuned("bullet/deformable_implicit");
  deformable.push_back({"bullet/deformable_explicit"});
  const Extrapolated bullet = time_to_error(stage, t, error_of, deformable);
  const Extrapolated given = time_to_error(stage, t, error_of, {{"bullet/soft_body_force"}});
  return compare(
      "64 x 64: Bullet's best deformable / best own, time to 1e-3", by_vectors(100, 75), own.time,
      bullet.time,
      fmt::format("own {} in {:.3g} ms; {}; {:.1f} where soft bodies are given our forces",
                  own_name, 1e3 * own.time.min, bullet.how, given.time.min / own.time.min));
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
  const auto rk4 = [&](double steps) { return after(study::rk4_steps(stage.scene()), t, steps); };
  const std::vector<double> step_counts{190, 220, 256, 320, 400, 512, 724, 1024, 2048};
  const Reached by_verlet = reach(1e-3, step_counts, verlet, error_of);
  const Reached by_rk4 = reach(1e-3, {70, 80, 90, 100, 128, 181, 256, 512}, rk4, error_of);
  const bool rk4_first = by_rk4.time.min < by_verlet.time.min;
  const Reached& own = rk4_first ? by_rk4 : by_verlet;

  rows.push_back(
      bullet_row(stage, t, error_of, own, rk4_first ? "RK4 f64" : "velocity Verlet f32"));

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
       {std::pair{std::size_t{11}, 8.0}, {std::size_t{32}, 10.0}, {std::size_t{64}, 15.0}})
    rows.push_back(implicit_row(n, goal));
  equal_error_rows(rows);
  return rows;
}

}  // namespace odeum::bench
