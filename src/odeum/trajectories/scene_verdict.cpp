// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/scene_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "odeum/cases/scene_case.hpp"

namespace odeum::trajectories {
namespace {

using scene::SceneProblem;

bool has_negative_damping(const scene::Scene& scene) {
  return std::any_of(scene.springs.begin(), scene.springs.end(),
                     [](const scene::Spring& spring) { return spring.damping < 0; }) ||
         std::any_of(
             scene.forces.begin(), scene.forces.end(), [](const scene::UniformForce& force) {
               const auto* const drag = std::get_if<scene::Drag>(&force);
               const auto* const quadratic = std::get_if<scene::QuadraticDrag>(&force);
               return (drag && drag->coefficient < 0) || (quadratic && quadratic->coefficient < 0);
             });
}

double norm(const scene::Vec3& v) { return std::hypot(v[0], v[1], v[2]); }

/// The most that wind adds to the scene's energy, W.
double power_of_wind(const scene::Scene& scene, std::size_t particles) {
  double power = 0;
  for (const scene::UniformForce& force : scene.forces)
    if (const auto* const wind = std::get_if<scene::Wind>(&force))
      power += static_cast<double>(particles) * wind->coefficient *
               std::pow(norm(wind->velocity), 2) / 4;
  return power;
}

}  // namespace

SceneErrors scene_errors(const SceneProblem& problem, const scene::RunResult& run,
                         const Truth& truth) {
  SceneErrors errors;
  std::vector<double> exact(problem.size());
  errors.size = cases::extent_of(problem.start().data(), problem.particles());
  for (const scene::Frame& frame : run.frames) {
    if (!(frame.t > 0) || frame.y.size() != exact.size() || !truth.at(frame.t, exact.data()))
      continue;
    errors.size = std::max(errors.size, cases::extent_of(exact.data(), problem.particles()));
    double largest = 0, sum = 0;
    std::size_t free = 0;
    for (std::size_t i = 0; i < problem.particles(); ++i) {
      if (!problem.bodies().free(i)) continue;
      const double* const a = frame.y.data() + 3 * i;
      const double* const b = exact.data() + 3 * i;
      const double apart = std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
      // A single particle has no extent: its way stands for it.
      const double* const start = problem.start().data() + 3 * i;
      errors.size =
          std::max(errors.size, std::hypot(b[0] - start[0], b[1] - start[1], b[2] - start[2]));
      largest = std::max(largest, apart);
      sum += apart;
      ++free;
    }
    errors.until = frame.t;
    errors.end_largest = largest;
    errors.end_mean = free == 0 ? 0 : sum / static_cast<double>(free);
    if (largest > errors.largest) {
      errors.largest = largest;
      errors.largest_at = frame.t;
    }
  }
  return errors;
}

std::vector<double> times_to_judge(const std::vector<const scene::RunResult*>& runs) {
  constexpr double most_numbers = 4e5;  // kept for each method of the reference
  std::set<double> times;
  for (const scene::RunResult* const run : runs) {
    if (run->frames.empty()) continue;
    const double numbers = static_cast<double>(run->frames.size() * run->frames.back().y.size() *
                                               std::max<std::size_t>(runs.size(), 1));
    const std::size_t apart = 1 + static_cast<std::size_t>(numbers / most_numbers);
    for (std::size_t k = run->frames.size(); k > 0; k -= std::min(k, apart))
      if (const double t = run->frames[k - 1].t; t > 0) times.insert(t);
  }
  return {times.begin(), times.end()};
}

std::string excess_of_energy(const scene::Scene& scene, const SceneProblem& problem,
                             const scene::RunResult& run) {
  if (!scene.emitters.empty() || has_negative_damping(scene) || run.frames.empty()) return {};
  const std::size_t free = problem.particles() - problem.structure().fixed;
  double mass = 0;
  for (std::size_t i = 0; i < problem.particles(); ++i)
    if (problem.bodies().free(i)) mass += problem.bodies().mass[i];
  const scene::Frame& start = run.frames.front();
  double stretch = problem.potential(start.y.data());  // of springs and penetrations alone
  for (std::size_t i = 0; i < problem.particles(); ++i)
    if (problem.bodies().free(i))
      for (std::size_t d = 0; d < 3; ++d)
        stretch += problem.bodies().mass[i] * scene.gravity[d] * start.y[3 * i + d];
  const double size = cases::extent_of(start.y.data(), problem.particles());
  const double allowed = start.kinetic + stretch + mass * norm(scene.gravity) * size;
  const double power = power_of_wind(scene, free);
  for (const scene::Frame& frame : run.frames) {
    const double gained = frame.kinetic + frame.potential - start.kinetic - start.potential;
    if (std::isfinite(gained) && gained <= allowed + power * frame.t) continue;
    return fmt::format(
        "the energy is {:.3g} J at t = {:.4g}; the exact motion has at most {:.3g} J there",
        frame.kinetic + frame.potential, frame.t,
        start.kinetic + start.potential + power * frame.t);
  }
  return {};
}

}  // namespace odeum::trajectories
