// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "odeum/judge/stability_search.hpp"
#include "odeum/measure/growth_meter.hpp"
#include "odeum/studies/spectrum.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::study {
namespace {

/// The eigenvalues along the solution that can limit a step: the largest in each of the sectors
/// into which the left half plane is cut. Small ones never do.
struct Rays : SpectrumAlong {
  const Case* c = nullptr;
};

Rays rays_of(const Case& c) {
  constexpr double sectors = 96, small = 0.05;
  Rays rays{spectrum_along(c, c.stops.back() - c.t0), &c};
  double largest = 0;
  for (const auto& z : rays.eigenvalues) largest = std::max(largest, std::abs(z));
  std::map<double, std::complex<double>> by_sector;
  for (const auto& z : rays.eigenvalues) {
    if (!(std::abs(z) > small * largest)) continue;
    auto& longest = by_sector[std::round(std::arg(z) / std::numbers::pi * 2 * sectors)];
    if (std::abs(z) > std::abs(longest)) longest = z;
  }
  rays.eigenvalues.clear();
  for (const auto& [sector, z] : by_sector) rays.eigenvalues.push_back(z);
  if (rays.reason.empty() && rays.eigenvalues.empty())
    rays.reason =
        "no eigenvalue along the solution has a negative real part or none: none limits "
        "a step";
  return rays;
}

/// A problem on which growth is measured: y' = z y, or, for methods that need equations of second
/// order, the oscillator, whose damping others of them do not take.
struct Plane {
  const Case* c;
  bool oscillator;
  Probe probe;
  bool runs(const std::string& solver) const {
    const Entrant* const entrant = probe.entrants.find(solver);
    return entrant && entrant->unfit.empty();
  }
};

std::vector<Plane> planes() {
  std::vector<Plane> found;
  for (const std::string name : {"lambda", "oscillator", "undamped"}) {
    const Case& c = measure::case_with_plane(name);
    found.push_back({&c, name != "lambda", c.probe()});
  }
  return found;
}

/// The point at a distance on the ray of an eigenvalue. Of an oscillator z is an eigenvalue; a real
/// one, of strong damping, has a slow one beside it.
judge::PlaneState point_on_ray(bool oscillator, const std::complex<double>& z, double x) {
  const std::complex<double> ray = z / std::abs(z);
  if (!oscillator) return {x * ray.real(), x * ray.imag()};
  if (ray.imag() > 1e-6) return {x, std::max(0.0, -ray.real())};
  constexpr double strong = 10;  // the damping ratio
  return {x / (strong + std::sqrt(strong * strong - 1)), strong};
}

/// A unit of work.
struct RayTask {
  const Rays* rays;
  const Plane* plane;
  SolverInfo info;
  std::string unfit;
};

StableStep answer(const RayTask& task) {
  auto row = named_row<StableStep>(*task.rays->c, task.info);
  if (!task.unfit.empty()) return not_applicable(row, task.unfit);
  if (!task.rays->reason.empty()) return not_applicable(row, task.rays->reason);
  const bool oscillator = task.plane->oscillator;
  const Probe probe = task.plane->c->probe();
  measure::GrowthMeter meter(probe, find_solver(probe.entrants, task.info.id()), oscillator,
                             measure::limit_length);
  row.status = to_string(Status::ok);
  for (const std::complex<double>& z : task.rays->eigenvalues) {
    const judge::LimitFound found = judge::find_limit([&](double x) {
      if (interrupted) throw Interrupted();
      const auto [first, second] = point_on_ray(oscillator, z, x);
      return meter.measure(first, second);
    });
    if (std::isnan(found.limit)) {
      row.status = to_string(meter.status());
      row.detail = meter.failure();
      return row;
    }
    const double step = found.limit / std::abs(z);
    const bool larger = std::isinf(step) && std::abs(z) > std::abs(row.eigenvalue);
    if (!std::isnan(row.step) && !(step < row.step) && !(larger && std::isinf(row.step))) continue;
    row.step = step;
    row.limit = found.limit;
    row.eigenvalue = z;
    row.detail = found.how;
  }
  if (task.rays->growing > 0)
    remark(row, fmt::format("for what decays: at one of the times an eigenvalue of {:.3g} grows, "
                            "as the solution itself does",
                            task.rays->growing));
  return row;
}

}  // namespace

StabilityResult measure_steps(const Options& options, const Runner& runner) {
  const std::vector<const Case*> cases = select_cases(options.cases);
  std::vector<Rays> rays(cases.size());
  parallel_for(cases.size(), runner.jobs(), [&](std::size_t i) { rays[i] = rays_of(*cases[i]); });
  const std::vector<Plane> all = planes();
  std::vector<RayTask> tasks;
  for (const Rays& each : rays)
    for (const Pair& pair : select_pairs({each.c}, options.solvers)) {
      RayTask task{&each, nullptr, pair.entrant->info, pair.entrant->unfit};
      const bool damped = std::ranges::any_of(
          each.eigenvalues, [](const auto& z) { return z.real() < -1e-6 * std::abs(z); });
      // An engine takes z as a force on a velocity, which it treats unlike that of a spring.
      const bool engine =
          task.info.common_use == CommonUse::engine && each.c->problem.view.second_order();
      for (const Plane& plane : all)
        if (!task.plane && plane.runs(task.info.id()) && (plane.oscillator || !engine) &&
            !(damped && plane.c->plane == "undamped"))
          task.plane = &plane;
      if (task.unfit.empty() && !task.info.fixed) task.unfit = "chooses its own steps only";
      if (task.unfit.empty() && !task.plane)
        task.unfit =
            "has no region of stability: it runs neither on y' = z y nor on the oscillator";
      tasks.push_back(std::move(task));
    }
  return runner.run(
      "steps", tasks, [](const RayTask& task) { return task.rays->c->id + " " + task.info.id(); },
      [](const RayTask& task) { return StabilityResult{.steps = {answer(task)}}; });
}

}  // namespace odeum::study
