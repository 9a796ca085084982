// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <memory>
#include <vector>

#include "odeum/scene/scene.hpp"

namespace odeum::adapters::bullet {

/// A length (m) that no run reaches, squares of which still fit a double. Bullet clamps speeds by
/// two lengths: a world's maximal displacement a step (1000 m as it comes), and for explicit
/// deformable bodies the bounding box, which the margin (0.25 m) widens. Both are moved out of the
/// way, since a clamp that binds is a different equation.
inline constexpr double beyond_reach = 1e30;

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
