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

/// Bullet clamps speeds, which changes the equation where the clamp acts. This disables a world's
/// clamp (default: 1000 m per step).
inline constexpr double no_displacement_limit = std::numeric_limits<double>::infinity();

/// The clamp of explicit deformable bodies, the diagonal of the bounding box per step, cannot be
/// disabled; the margin (m; default 0.25) widens the box. This one can still be squared.
inline constexpr double endless_margin = 1e140;

/// A run that reaches this distance (m) has diverged. It is far below the margin, since damping may
/// reduce a clamped speed within the step.
inline constexpr double beyond_reach = 1e100;

/// The components of every Bullet world. Nothing collides here, so the pools are small: by default
/// they take megabytes, which Bullet clears at each creation.
struct CollisionParts {
  CollisionParts() : configuration(small_pools()), dispatcher(&configuration) {}

  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher;
  btDbvtBroadphase broadphase;

 private:
  static btDefaultCollisionConstructionInfo small_pools();
};

/// One soft body for a scene: node i is particle i with its position and velocity of the state (all
/// positions, then all velocities), link s is spring s with its rest length. Sleeping and
/// collisions are disabled.
std::unique_ptr<btSoftBody> make_body(btSoftBodyWorldInfo& world_info, const scene::Scene& scene,
                                      const std::vector<double>& state);

}  // namespace odeum::adapters::bullet
