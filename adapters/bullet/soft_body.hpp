// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <limits>
#include <memory>
#include <vector>

#include "odeum/scene/model/scene.hpp"

namespace odeum::adapters::bullet {

/// Bullet clamps speeds, which makes another equation where it binds. A world's clamp (1000 m a
/// step as it comes) is switched off by this.
inline constexpr double no_displacement_limit = std::numeric_limits<double>::infinity();

/// The clamp of explicit deformable bodies, the diagonal of the bounding box a step, cannot be
/// switched off: the margin (m; 0.25 as it comes) widens the box. This one still has a square.
inline constexpr double endless_margin = 1e140;

/// A run that gets here (m) has diverged. It lies far below the margin, since damping may bring a
/// speed that was clamped down again within the step.
inline constexpr double beyond_reach = 1e100;

/// What every Bullet world asks for. Nothing collides here, so the pools are kept small: as they
/// come they take megabytes, which Bullet clears at each creation.
struct CollisionParts {
  CollisionParts() : configuration(small_pools()), dispatcher(&configuration) {}

  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;

 private:
  static btDefaultCollisionConstructionInfo small_pools();
};

/// One soft body for a scene: node i is particle i, placed and moving as the state says (all
/// positions, then all velocities), and link s is spring s with its rest length. It never sleeps
/// and never collides.
std::unique_ptr<btSoftBody> make_body(btSoftBodyWorldInfo& world_info, const scene::Scene& scene,
                                      const std::vector<double>& state);

}  // namespace odeum::adapters::bullet
