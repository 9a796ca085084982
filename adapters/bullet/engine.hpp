// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "odeum/core/guard.hpp"
#include "odeum/scene/model/scene.hpp"

class btSoftBody;

namespace odeum::adapters::bullet {

/// A Bullet world with a scene built as one soft body, ready to step. Each solve has its own;
/// worlds share no state while they step (see the findings), so that solves may run in several
/// threads.
class Engine {
 public:
  virtual ~Engine() = default;
  /// Applies to the nodes the forces that the adapter computes.
  virtual void exert(double /*t*/, Guard&) {}
  /// One step of h seconds. False: Bullet did not step, since h is below its SIMD_EPSILON.
  virtual bool step(double h) = 0;
  /// How many products of the forces' derivative with a vector all steps so far took.
  virtual std::uint64_t products() const { return 0; }
  virtual const btSoftBody& body() const = 0;
};

/// Settings of an engine's step. Iterations are those of Request::options; 0: Bullet's own.
struct Plan {
  double h = 0;    ///< s
  int sweeps = 0;  ///< over the constraints, or of the linear solver
  int newton = 0;  ///< of Newton's method around it
};

/// Builds the world for a scene, a state (all positions, then all velocities) and a plan.
using MakeEngine = std::unique_ptr<Engine> (*)(const scene::Scene& scene,
                                               const std::vector<double>& state, const Plan& plan);

std::unique_ptr<Engine> make_soft_body_force(const scene::Scene&, const std::vector<double>&,
                                             const Plan&);
std::unique_ptr<Engine> make_soft_body_collision(const scene::Scene&, const std::vector<double>&,
                                                 const Plan&);
std::unique_ptr<Engine> make_soft_body_links(const scene::Scene&, const std::vector<double>&,
                                             const Plan&);
std::unique_ptr<Engine> make_soft_body_links_stock(const scene::Scene&, const std::vector<double>&,
                                                   const Plan&);
std::unique_ptr<Engine> make_deformable_explicit(const scene::Scene&, const std::vector<double>&,
                                                 const Plan&);
std::unique_ptr<Engine> make_deformable_implicit(const scene::Scene&, const std::vector<double>&,
                                                 const Plan&);
std::unique_ptr<Engine> make_deformable_self_collision(const scene::Scene&,
                                                       const std::vector<double>&, const Plan&);

}  // namespace odeum::adapters::bullet
