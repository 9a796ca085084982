// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "odeum/problem/concepts.hpp"
#include "odeum/problem/extended_problem.hpp"
#include "odeum/problem/shifted_solver.hpp"
#include "odeum/scene/model/emission.hpp"
#include "odeum/scene/model/scene.hpp"
#include "odeum/scene/model/terms.hpp"
#include "odeum/scene/springs/grid_cloth.hpp"

namespace odeum::scene {

/// The structure of a scene, which decides the methods and kernels that it allows.
struct Structure {
  std::vector<TermInfo> terms;
  std::size_t particles = 0, fixed = 0;
  bool separable = false;  ///< the acceleration does not depend on the velocity
  bool linear = false;     ///< in positions and velocities
  /// See TermInfo; lifetimes count as kinks.
  int order_kept = any_order;
  bool smooth() const { return order_kept == any_order; }
  bool closed_form = false;  ///< free particles under a constant force
  std::string kernel;        ///< how the springs are computed
};

/// A scene compiled to exactly the terms that it declares, as q'' = a(q, v): all positions x y z,
/// then all velocities, 6 entries a particle; fixed particles do not move. It depends on time only
/// where particles have lifetimes, outside of which no force acts on them. Springs that form a
/// regular grid are computed by gathering (GridSprings), others edge by edge.
class SceneProblem {
 public:
  static constexpr std::size_t dimension = dynamic;
  static constexpr bool velocity_dependent = true;  // as far as the type knows
  bool depends_on_velocity() const { return !structure_.separable; }

  /// Throws std::invalid_argument for a spring end that is not a particle, a mass that is not
  /// positive on a free particle, a velocity on a fixed one, or a velocity_matrix. `lives`: one for
  /// each particle (see WholeScene); empty: all are there all the time.
  explicit SceneProblem(const Scene& scene, std::vector<Lifetime> lives = {});

  const Structure& structure() const { return structure_; }
  std::size_t particles() const { return bodies_.size(); }
  std::size_t size() const { return 6 * particles(); }
  /// The initial state of the scene.
  const std::vector<double>& start() const { return start_; }

  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, size() / 2, t, y, dydt);
  }
  /// v may be null where the scene is separable.
  void acceleration(double t, const double* q, const double* v, double* a) const;
  bool offers_time_derivative() const { return !lives_.empty(); }
  /// 0, since the forces jump.
  void time_derivative(double, const double*, double* dfdt) const {
    std::fill_n(dfdt, size(), 0.0);
  }
  void jacobian_times(double t, const double* y, const double* x, double* product) const;
  /// Conjugate gradients on a grid, otherwise a sparse direct solver.
  std::unique_ptr<ShiftedSolver> shifted_solver() const;
  /// Every derivative of a force by a position and a velocity.
  void blocks(const double* q, const double* v, BlockSink& sink) const;
  /// Whether the derivatives by positions and by velocities are symmetric: there are only springs
  /// that damp the whole relative velocity, or none.
  bool symmetric() const { return terms_.empty(); }

  /// See WithDamping; for springs that damp the whole relative velocity, and no other damping.
  bool offers_damp() const { return symmetric() && !structure_.separable && lives_.empty(); }
  bool offers_undamped_acceleration() const { return offers_damp(); }
  void undamped_acceleration(double t, const double* q, double* a) const;
  std::uint64_t damp(double t, const double* q, double h, double* v, double relative) const;

  double energy(const double* y) const { return kinetic(y) + potential(y); }  ///< J
  double kinetic(const double* y) const;
  double potential(const double* y) const;       ///< of gravity, springs and penetrations
  Vec3 momentum(const double* y) const;          ///< of the free particles
  Vec3 angular_momentum(const double* y) const;  ///< about the origin

  /// The state at time t after y0, where `structure().closed_form`.
  void closed_form(double t, const double* y0, double* y) const;

  const Bodies& bodies() const { return bodies_; }
  /// The springs without axial damping.
  const std::vector<Spring>& springs() const { return springs_.springs(); }
  /// The grid that `springs` form; null where they are computed edge by edge.
  const GridCloth<double>* grid() const { return grid_ ? &*grid_ : nullptr; }
  /// The scene that it was compiled from, for physics engines.
  const std::shared_ptr<const Scene>& scene() const { return scene_; }
  /// Whether it has no terms other than gravity and `springs`.
  bool plain() const { return terms_.empty() && lives_.empty(); }
  const std::vector<Lifetime>& lives() const { return lives_; }
  bool acts(std::size_t particle, double t) const {
    return lives_.empty() || lives_[particle].holds(t);
  }

 private:
  std::uint64_t damp_edges(double h, double* v, double relative) const;
  void describe(const Scene& scene);

  Bodies bodies_;
  Vec3 gravity_;
  std::vector<double> start_;
  EdgeSprings springs_;
  std::optional<GridCloth<double>> grid_;
  std::vector<std::unique_ptr<Term>> terms_;  ///< beside gravity and springs_
  std::shared_ptr<const Scene> scene_;
  std::vector<Lifetime> lives_;
  Structure structure_;
};

/// The same equation in extended precision, its data the doubles of the scene; gravity and springs
/// only. Without a truth.
ExtendedProblem extended_problem(const Scene& scene);

}  // namespace odeum::scene
