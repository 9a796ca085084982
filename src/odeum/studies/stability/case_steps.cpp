// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "odeum/cases/catalogue.hpp"
#include "odeum/judge/stability_search.hpp"
#include "odeum/studies/spectrum.hpp"
#include "odeum/studies/stability/growth_meter.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::study {
namespace {

/// The eigenvalues of a case that can limit a step: the largest in each of the sectors into which
/// the left half plane is cut. Small ones never do.
struct Rays {
  const Case* c = nullptr;
  std::string reason;  ///< why there are none; empty: there are
  std::vector<std::complex<double>> eigenvalues;
};

Rays rays_of(const Case& c) {
  constexpr double sectors = 96, small = 0.05;
  const SpectrumAlong along = spectrum_along(c, c.stops.back() - c.t0);
  Rays rays{&c, along.reason, {}};
  double largest = 0;
  for (const auto& z : along.eigenvalues) largest = std::max(largest, std::abs(z));
  std::map<double, std::complex<double>> by_sector;
  for (const auto& z : along.eigenvalues) {
    if (!(std::abs(z) > small * largest)) continue;
    auto& longest = by_sector[std::round(std::arg(z) / std::numbers::pi * 2 * sectors)];
    if (std::abs(z) > std::abs(longest)) longest = z;
  }
  for (const auto& [sector, z] : by_sector) rays.eigenvalues.push_back(z);
  if (rays.reason.empty() && rays.eigenvalues.empty())
    rays.reason =
        "no eigenvalue along the solution has a negative real part or none: none limits "
        "a step";
  return rays;
}

/// A unit of work.
struct RayTask {
  const Rays* rays;
  const Case* plane;  ///< of y' = z y
  SolverInfo info;
  std::string unfit;
};

StableStep answer(const RayTask& task) {
  auto row = named_row<StableStep>(*task.rays->c, task.info);
  if (!task.unfit.empty()) return not_applicable(row, task.unfit);
  if (!task.rays->reason.empty()) return not_applicable(row, task.rays->reason);
  const Probe probe = task.plane->probe();
  GrowthMeter meter(probe, find_solver(probe.entrants, task.info.id()), false, limit_length);
  row.status = to_string(Status::ok);
  for (const std::complex<double>& z : task.rays->eigenvalues) {
    const std::complex<double> ray = z / std::abs(z);
    const judge::LimitFound found = judge::find_limit([&](double x) {
      if (interrupted) throw Interrupted();
      return meter.measure(x * ray.real(), x * ray.imag());
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
  return row;
}

}  // namespace

StabilityResult measure_steps(const Options& options, const Runner& runner) {
  const std::vector<const Case*> cases = select_cases(options.cases);
  std::vector<Rays> rays(cases.size());
  parallel_for(cases.size(), runner.jobs(), [&](std::size_t i) { rays[i] = rays_of(*cases[i]); });
  const Case* plane = nullptr;
  for (const Case& c : all_cases())
    if (c.plane == "lambda") plane = &c;
  if (!plane) throw std::logic_error("no case has the plane of lambda");
  const Probe probe = plane->probe();
  std::vector<RayTask> tasks;
  for (const Rays& each : rays)
    for (const Pair& pair : select_pairs({each.c}, options.solvers)) {
      RayTask task{&each, plane, pair.entrant->info, pair.entrant->unfit};
      const bool runs_there =
          std::any_of(probe.entrants.begin(), probe.entrants.end(), [&](const Entrant& entrant) {
            return entrant.unfit.empty() && entrant.info.id() == task.info.id();
          });
      if (task.unfit.empty() && !task.info.fixed) task.unfit = "chooses its own steps only";
      if (task.unfit.empty() && !runs_there)
        task.unfit = "has no region in the plane of z: it does not run on y' = z y";
      tasks.push_back(std::move(task));
    }
  return runner.run(
      "steps", tasks, [](const RayTask& task) { return task.rays->c->id + " " + task.info.id(); },
      [](const RayTask& task) {
        return StabilityResult{{}, {}, {answer(task)}};
      });
}

}  // namespace odeum::study
