// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "odeum/problem/shifted_solver.hpp"
#include "odeum/scene/model/description.hpp"
#include "odeum/scene/model/mass_spring.hpp"
#include "odeum/scene/model/terms.hpp"

namespace odeum::scene {

/// What a scene was found to be, and so which methods and kernels it allows.
struct Structure {
  std::vector<TermInfo> terms;
  std::size_t particles = 0, fixed = 0;
  bool separable = false;    ///< the acceleration does not look at the velocity
  bool linear = false;       ///< in positions and velocities
  bool smooth = true;        ///< no kink: neither contacts nor tension-only springs
  bool closed_form = false;  ///< free particles under a constant force
  std::string kernel;        ///< how the springs are computed
};

/// A scene compiled to exactly the terms that it declares, as q'' = a(q, v): state y = [q, v], 6
/// entries a particle. It does not depend on time. Springs that damp the whole relative velocity
/// (or nothing) and gravity are a MassSpring; every other term is an object of its own.
class SceneProblem {
 public:
  explicit SceneProblem(const Description& description);
  SceneProblem(const SceneProblem&) = delete;
  SceneProblem& operator=(const SceneProblem&) = delete;

  const Structure& structure() const { return structure_; }
  std::size_t particles() const { return bodies_.size(); }
  std::size_t size() const { return 6 * particles(); }
  /// Positions and velocities as the description has them.
  const std::vector<double>& start() const { return start_; }

  /// v may be null where the scene is separable.
  void acceleration(const double* q, const double* v, double* a) const;
  void jacobian_times(const double* y, const double* x, double* product) const;
  std::unique_ptr<ShiftedSolver> shifted_solver() const;
  /// Every derivative of a force by a position and a velocity.
  void blocks(const double* q, const double* v, BlockSink& sink) const;

  double kinetic(const double* y) const;
  double potential(const double* y) const;       ///< gravity, springs, contacts as deep as they are
  Vec3 momentum(const double* y) const;          ///< of the particles that are free
  Vec3 angular_momentum(const double* y) const;  ///< about the origin

  /// The state at time t after y0, where `structure().closed_form`.
  void closed_form(double t, const double* y0, double* y) const;

  const Bodies& bodies() const { return bodies_; }
  /// The scene in a physics engine's terms; null where it has others.
  std::shared_ptr<const Scene> plain_scene() const { return plain_; }
  /// From now on what is worked out is counted there; null stops it.
  void count_into(Tally* tally) { tally_ = tally; }

 private:
  void add_springs(const Description& description);
  void describe(const Description& description);

  Bodies bodies_;
  Vec3 gravity_;
  std::vector<double> start_;
  std::optional<MassSpring> springs_;  ///< with gravity, where there are such springs
  std::vector<std::unique_ptr<Term>> terms_;
  std::vector<std::string> names_;  ///< of terms_
  std::shared_ptr<const Scene> plain_;
  Structure structure_;
  Tally* tally_ = nullptr;
};

}  // namespace odeum::scene
