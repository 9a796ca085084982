// SPDX-License-Identifier: BSD-3-Clause
// References of scenes, with emitted particles each by itself.
#include <algorithm>
#include <cmath>
#include <utility>

#include "odeum/core/parallel.hpp"
#include "odeum/truth/scene_system.hpp"

namespace odeum::truth {
namespace {

using scene::Lifetime;
using scene::Scene;
using scene::SceneProblem;
using Problem = std::shared_ptr<const SceneProblem>;

/// Particles that move without regard to the others: first .. first + count.
struct Part {
  std::size_t first = 0, count = 0;
  Lifetime life;
  double birth() const { return std::max(life.birth, 0.0); }
};

/// The listed particles together, each emitted one by itself.
std::vector<Part> parts_of(const SceneProblem& problem) {
  std::vector<Part> parts;
  const std::vector<Lifetime>& lives = problem.lives();
  const auto is_listed = [](const Lifetime& life) { return std::isinf(life.birth); };
  const auto listed = static_cast<std::size_t>(std::ranges::count_if(lives, is_listed));
  if (listed > 0) parts.push_back({0, listed, {}});
  for (std::size_t i = listed; i < lives.size(); ++i) parts.push_back({i, 1, lives[i]});
  return parts;
}

/// The scene of a part, from its birth on.
Problem problem_of(const SceneProblem& whole, const Part& part) {
  Scene scene = *whole.scene();
  const auto begin = scene.particles.begin() + static_cast<std::ptrdiff_t>(part.first);
  scene.particles = {begin, begin + static_cast<std::ptrdiff_t>(part.count)};
  if (part.first > 0) scene.springs.clear();
  for (scene::Particle& particle : scene.particles)
    for (std::size_t d = 0; d < 3; ++d) particle.position[d] += part.birth() * particle.velocity[d];
  return std::make_shared<const SceneProblem>(scene);
}

/// The states of a part at the times: on its straight way, by a reference as long as it lives.
class Motion {
 public:
  Motion(const SceneProblem& whole, const Part& part, const std::vector<double>& times,
         const TruthBounds& bounds)
      : part_(part), problem_(problem_of(whole, part)) {
    std::vector<double> asked;
    for (const double t : times)
      if (t > part.birth() && t < part.life.death) asked.push_back(t - part.birth());
    if (!times.empty() && part.life.death <= times.back())
      asked.push_back(part.life.death - part.birth());
    if (!asked.empty()) reference_ = compute_reference(system_of(problem_), asked, {}, bounds);
  }

  const Reference& reference() const { return reference_; }
  /// Its positions and velocities, and bounds of their errors; false: not known.
  bool at(double t, Real* q, Real* v, double* floor_q, double* floor_v) const {
    const std::size_t n = 3 * part_.count;
    const double since = std::min(t, part_.life.death) - part_.birth();
    const std::vector<double>& start = problem_->start();
    State state(start.begin(), start.end());
    std::vector<double> floors(2 * n, 0);
    if (since > 0) {
      const auto k = static_cast<std::size_t>(std::ranges::find(reference_.times, since) -
                                              reference_.times.begin());
      if (k == reference_.times.size()) return false;
      state = reference_.states[k];
      floors = reference_.floors[k];
    }
    const Real flown = since > 0 ? std::max(t - part_.life.death, 0.0) : since;
    for (std::size_t d = 0; d < n; ++d) {
      q[d] = state[d] + flown * state[n + d];
      v[d] = state[n + d];
      floor_q[d] = floors[d] + static_cast<double>(std::abs(flown)) * floors[n + d];
      floor_v[d] = floors[n + d];
    }
    return true;
  }

 private:
  Part part_;
  Problem problem_;
  Reference reference_;
};

}  // namespace

Reference reference_of(const Problem& problem, const std::vector<double>& times,
                       const TruthBounds& bounds) {
  if (problem->lives().empty()) return compute_reference(system_of(problem), times, {}, bounds);
  const std::vector<Part> parts = parts_of(*problem);
  std::vector<std::unique_ptr<Motion>> motions(parts.size());
  constexpr unsigned at_once = 2;  // each reference runs up to three methods at once
  parallel_for(parts.size(), at_once, [&](std::size_t i) {
    motions[i] = std::make_unique<Motion>(*problem, parts[i], times, bounds);
  });
  Reference whole;
  for (const auto& motion : motions) {
    const Reference& one = motion->reference();
    if (!one.methods.empty()) whole.methods = one.methods + ", each emitted particle by itself";
    whole.disagreement = std::max(whole.disagreement, one.disagreement);
    if (whole.end.empty()) whole.end = one.end;
  }
  const std::size_t n = problem->size() / 2;
  for (const double t : times) {
    State state(2 * n);
    std::vector<double> floors(2 * n);
    bool known = true;
    for (std::size_t i = 0; i < parts.size() && known; ++i) {
      const std::size_t q = 3 * parts[i].first, v = n + q;
      known = motions[i]->at(t, &state[q], &state[v], &floors[q], &floors[v]);
    }
    if (!known) break;
    whole.known_until = t;
    whole.times.push_back(t);
    whole.floors.push_back(std::move(floors));
    whole.states.push_back(std::move(state));
  }
  return whole;
}

}  // namespace odeum::truth
