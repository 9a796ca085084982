// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/trajectories/scene_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "odeum/cases/scene_case.hpp"

namespace odeum::trajectories {
namespace {

using scene::SceneProblem;

bool has_negative_damping(const scene::Scene& scene) {
  return std::ranges::any_of(scene.springs,
                             [](const scene::Spring& spring) { return spring.damping < 0; }) ||
         std::ranges::any_of(scene.forces, [](const scene::UniformForce& force) {
           const auto* const drag = std::get_if<scene::Drag>(&force);
           const auto* const quadratic = std::get_if<scene::QuadraticDrag>(&force);
           return (drag && drag->coefficient < 0) || (quadratic && quadratic->coefficient < 0);
         });
}

double norm(const scene::Vec3& v) { return std::hypot(v[0], v[1], v[2]); }

/// The most that wind adds to the energy of a particle, W.
double power_of_wind(const scene::Scene& scene) {
  double power = 0;
  for (const scene::UniformForce& force : scene.forces)
    if (const auto* const wind = std::get_if<scene::Wind>(&force))
      power += wind->coefficient * std::pow(norm(wind->velocity), 2) / 4;
  return power;
}

bool dissipates(const scene::Scene& scene) {
  return !scene.forces.empty() ||
         std::ranges::any_of(scene.particles,
                             [](const scene::Particle& particle) { return particle.drag > 0; }) ||
         std::ranges::any_of(scene.springs,
                             [](const scene::Spring& spring) { return spring.damping > 0; }) ||
         std::ranges::any_of(
             scene.contacts,
             [](const auto& contact) {
               return std::visit([](const scene::Penalty& p) { return p.damping + p.friction > 0; },
                                 contact);
             }) ||
         std::ranges::any_of(scene.surfaces,
                             [](const scene::Surface& surface) { return surface.friction > 0; });
}

/// More than the energy that the rounding of positions makes: of springs, by as many units of the
/// last place as a long run at rest adds up, and of the sum of what particles have in gravity.
double energy_of_rounding(const scene::Scene& scene, const std::vector<scene::Particle>& all) {
  constexpr double part = 256 * std::numeric_limits<double>::epsilon();
  double sum = 0, stiffness = 0, farthest = 0;
  for (const scene::Particle& particle : all) {
    const double distance = norm(particle.position);
    farthest = std::max(farthest, distance);
    if (!particle.fixed) sum += part * particle.mass * norm(scene.gravity) * distance;
  }
  for (const scene::Spring& spring : scene.springs) stiffness += spring.stiffness;
  return sum + stiffness * std::pow(part * farthest, 2);
}

/// What the free particles of a frame brought with them: those of the scene at its start, emitted
/// ones at their birth; in J.
struct Brought {
  double kinetic = 0, gravity = 0;
  double fallen = 0;  ///< their energy in gravity then, less the present one
  std::size_t free = 0;
};
Brought brought_by(const scene::Scene& scene, const std::vector<scene::Particle>& all,
                   const scene::Frame& frame) {
  Brought sum;
  for (std::size_t k = 0; k < frame.ids.size(); ++k) {
    const scene::Particle& particle = all.at(frame.ids[k]);
    if (particle.fixed) continue;
    ++sum.free;
    sum.kinetic += particle.mass * std::pow(norm(particle.velocity), 2) / 2;
    for (std::size_t d = 0; d < 3; ++d) {
      const double weight = particle.mass * scene.gravity[d];
      sum.gravity -= weight * particle.position[d];
      sum.fallen += weight * (frame.y[3 * k + d] - particle.position[d]);
    }
  }
  return sum;
}

std::string text_of_pair(const scene::SurfacePair& pair) {
  const auto [a, b, c, d] = pair.x;
  if (pair.kind == scene::SurfacePair::Kind::corner)
    return fmt::format("particle {} and ball {}", a, c);
  if (pair.kind == scene::SurfacePair::Kind::edges)
    return fmt::format("edges {}-{} and {}-{}", a, b, c, d);
  return fmt::format("particle {} and triangle {}-{}-{}", c, a, b, d);
}

}  // namespace

SceneErrors scene_errors(const SceneProblem& problem, const scene::RunResult& run,
                         const Truth& truth) {
  SceneErrors errors;
  const std::size_t n = problem.size() / 2;
  std::vector<double> exact(2 * n), there;
  const auto apart = [](const double* a, const double* b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
  };
  for (const scene::Frame& frame : run.frames) {
    if (!(frame.t > 0)) {
      errors.size = cases::extent_of(frame.y.data(), frame.ids.size());
      continue;
    }
    if (frame.ids.empty() || !truth.at(frame.t, exact.data())) continue;
    double largest = 0, sum = 0;
    std::size_t free = 0;
    there.clear();
    for (std::size_t k = 0; k < frame.ids.size(); ++k) {
      const std::size_t i = frame.ids[k];
      const double* const b = exact.data() + 3 * i;
      there.insert(there.end(), b, b + 3);
      if (!problem.bodies().free(i)) continue;
      const double error = apart(frame.y.data() + 3 * k, b);
      // A single particle has no extent: its way stands for it.
      scene::Vec3 start{};
      const double birth = problem.lives().empty() ? 0 : std::max(problem.lives()[i].birth, 0.0);
      for (std::size_t d = 0; d < 3; ++d)
        start[d] = problem.start()[3 * i + d] + birth * problem.start()[n + 3 * i + d];
      errors.size = std::max(errors.size, apart(b, start.data()));
      largest = std::max(largest, error);
      sum += error;
      ++free;
    }
    errors.size = std::max(errors.size, cases::extent_of(there.data(), frame.ids.size()));
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

std::string excess_of_energy(const scene::Scene& scene, const scene::RunResult& run) {
  if (has_negative_damping(scene) || run.frames.empty()) return {};
  std::vector<scene::Particle> all = scene.particles;
  for (const auto& emitted : scene::emitted_particles(scene.emitters, run.frames.back().t))
    all.push_back(emitted.particle);
  const scene::Frame& start = run.frames.front();
  const Brought first = brought_by(scene, all, start);
  const double stretch = start.kinetic + start.potential - first.kinetic - first.gravity;
  const bool falls = dissipates(scene);
  const double rounding = energy_of_rounding(scene, all);
  double kinetic = 0, fallen = 0, lowest = 0;
  std::size_t seen = 0;
  for (std::size_t k = 0; k < run.frames.size(); ++k) {
    // What a step of the method exchanges may show later: up to twice the time, at least some
    // frames.
    constexpr std::size_t ahead = 10;
    for (; seen < std::min(2 * k + ahead, run.frames.size()); ++seen) {
      const Brought brought = brought_by(scene, all, run.frames[seen]);
      kinetic = std::max(kinetic, brought.kinetic);
      // Where it is not finite, the energy is neither.
      if (brought.fallen > fallen) fallen = brought.fallen;
    }
    const scene::Frame& frame = run.frames[k];
    const Brought brought = brought_by(scene, all, frame);
    // The potential of attraction is negative.
    const double allowed = kinetic + std::abs(stretch) + fallen + rounding,
                 energy = frame.kinetic + frame.potential;
    const double most = brought.kinetic + brought.gravity + stretch +
                        power_of_wind(scene) * static_cast<double>(brought.free) * frame.t;
    const double gained = energy - most;
    lowest = std::min(lowest, gained);
    if (gained <= allowed && !(falls && gained - lowest > 2 * allowed)) continue;
    return fmt::format(
        "the energy is {:.3g} J at t = {:.4g}; the exact motion has at most {:.3g} J {}", energy,
        frame.t, gained <= allowed ? lowest + most : most,
        gained <= allowed ? "after what was lost before" : "there");
  }
  return {};
}

judge::JudgedAnswer scene_answer(const scene::RunResult& run, Mode mode, const std::string& excess,
                                 const SceneErrors* errors) {
  constexpr double whole = 1, tenth = 0.1;
  if (run.status != Status::ok) return {.answer = judge::Answer::none, .reason = {}};
  const auto wrong = [](std::string reason) {
    return judge::JudgedAnswer{.answer = judge::Answer::wrong, .reason = std::move(reason)};
  };
  if (!excess.empty()) return wrong("it has blown up: " + excess);
  if (run.contacts.passed > 0)
    return wrong(fmt::format("{} pairs passed through each other", run.contacts.passed));
  judge::JudgedAnswer judged;
  if (mode == Mode::adaptive) judged.answer = judge::Answer::undetermined;
  if (!errors || errors->until == 0) return judged;
  const double part = errors->size > 0 ? errors->largest / errors->size : 0;
  if (part >= whole)
    return wrong(fmt::format("it has diverged, by more than the {:.3g} m that the scene is large",
                             errors->size));
  judged.reason =
      fmt::format("{:.2g} % of the scene's size of {:.3g} m{}", 100 * part, errors->size,
                  part > tenth ? ", which does not predict its motion" : "");
  return judged;
}

std::string text_of_contacts(const scene::Contacts& contacts) {
  const scene::Touching& deepest = contacts.deepest;
  std::string text = "contacts   ";
  text += deepest.deepest > 0
              ? fmt::format("deepest {:.3g} m of a thickness of {:.3g} m, at t = {:.4g}, {}",
                            deepest.deepest, deepest.thickness, contacts.deepest_at,
                            text_of_pair(deepest.pair))
              : "none";
  text +=
      contacts.passed == 0
          ? fmt::format("; nothing passed through, between states {:.3g} s apart", contacts.apart)
          : fmt::format(
                "; {} pairs passed through each other, the first in the {:.3g} s before t = "
                "{:.6g}: "
                "{}",
                contacts.passed, contacts.apart, contacts.first_passed,
                text_of_pair(contacts.first_pair));
  return text;
}

}  // namespace odeum::trajectories
