// SPDX-License-Identifier: BSD-3-Clause
// Soft bodies in btSoftRigidDynamicsWorld: with forces applied to their nodes, or with links; and
// with Bullet's own collisions.
#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "engine.hpp"
#include "exerted.hpp"
#include "expressible.hpp"
#include "soft_body.hpp"

namespace odeum::adapters::bullet {
namespace {

class ClassicEngine : public Engine {
 public:
  ClassicEngine(const scene::Scene& scene, const std::vector<double>& state, bool springs)
      : exerted_(scene, springs),
        world_(&parts_.dispatcher, &parts_.broadphase, &solver_, &parts_.configuration) {
    btSoftBodyWorldInfo& info = world_.getWorldInfo();
    info.m_gravity.setValue(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
    info.m_maxDisplacement = no_displacement_limit;
    body_ = make_body(info, scene, state);
    world_.addSoftBody(body_.get());
  }

  void exert(double t, Guard& guard) override {
    if (exerted_.any()) add_forces(t, {}, guard);
  }
  bool step(double h) override { return world_.stepSimulation(h, 0) == 1; }
  const btSoftBody& body() const override { return *body_; }

 protected:
  btSoftBody& body() { return *body_; }
  /// A rigid body that stays where it is.
  void add_solid(std::unique_ptr<btCollisionShape> shape, const btTransform& at, double friction) {
    btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shape.get());
    info.m_startWorldTransform = at;
    info.m_friction = friction;
    solids_.push_back(std::make_unique<btRigidBody>(info));
    shapes_.push_back(std::move(shape));
    world_.addRigidBody(solids_.back().get());
  }
  void add_forces(double t, const scene::Mat3& matrix, Guard& guard) {
    exerted_.visit(t, *body_, matrix, guard, [&](std::size_t i, const scene::Vec3& f) {
      body_->addForce(btVector3(f[0], f[1], f[2]), static_cast<int>(i));
    });
  }

 private:
  Exerted exerted_;
  CollisionParts parts_;
  btSequentialImpulseConstraintSolver solver_;
  // They outlive the world, which only refers to them.
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> solids_;
  std::unique_ptr<btSoftBody> body_;
  btSoftRigidDynamicsWorld world_;
};

/// The adapter applies the forces of all terms but gravity, which is the world's.
class ForceEngine final : public ClassicEngine {
 public:
  ForceEngine(const scene::Scene& scene, const std::vector<double>& state)
      : ClassicEngine(scene, state, true), medium_(scene.velocity_matrix) {
    body().m_links.clear();
    body().m_cfg.piterations = 0;  // otherwise velocities are recomputed from positions
  }

  void exert(double t, Guard& guard) override { add_forces(t, medium_, guard); }

 private:
  scene::Mat3 medium_;
};

/// The adapter applies springs and uniform forces; contacts are Bullet's own: a node that is nearer
/// to a solid than the margin is projected out of it, without a rebound; friction takes its
/// coefficient of the sliding at each step.
class CollisionEngine final : public ClassicEngine {
 public:
  CollisionEngine(const scene::Scene& scene, const std::vector<double>& state)
      : ClassicEngine(without_contacts(scene), state, true) {
    body().m_links.clear();
    body().m_cfg.collisions = btSoftBody::fCollision::SDF_RS;
    body().m_cfg.kDF = 1;  // of the node; the solid has the friction of the contact
    body().getCollisionShape()->setMargin(*common_radius(scene));
    double voxel = 0.25;
    for (const scene::Contact& contact : scene.contacts) {
      if (const auto* const plane = std::get_if<scene::PlaneContact>(&contact)) add(*plane);
      if (const auto* const sphere = std::get_if<scene::SphereContact>(&contact)) {
        // Distances are interpolated between points of a grid, 0.25 m apart by default.
        voxel = std::min(voxel, sphere->radius / 16);
        add_solid(std::make_unique<btSphereShape>(sphere->radius),
                  btTransform(btQuaternion::getIdentity(), vector_of(sphere->center)),
                  sphere->friction);
      }
    }
    auto& distances = body().m_worldInfo->m_sparsesdf;
    distances.setDefaultVoxelsz(voxel);
    distances.Reset();  // takes it
  }

 private:
  static scene::Scene without_contacts(scene::Scene scene) {
    scene.contacts.clear();
    return scene;
  }
  static btVector3 vector_of(const scene::Vec3& v) { return {v[0], v[1], v[2]}; }

  /// Distances of nodes are to convex shapes only, and btStaticPlaneShape is none: a large box
  /// whose upper face is the plane.
  void add(const scene::PlaneContact& plane) {
    constexpr double half = 100, depth = 1;  // m
    const btVector3 normal = vector_of(plane.normal);
    add_solid(std::make_unique<btBoxShape>(btVector3(half, half, depth)),
              btTransform(shortestArcQuat(btVector3(0, 0, 1), normal),
                          vector_of(plane.point) - depth * normal),
              plane.friction);
  }
};

/// Position-based links. A link is projected towards its rest length by the share kLST in each of
/// `piterations` sweeps; velocities follow from the positions, times 1 - kDP.
class LinkEngine final : public ClassicEngine {
 public:
  /// `matched`: kLST such that the strain of a single link is multiplied by 1/(1 + k w h^2) per
  /// step, as by backward Euler at small strain, with w the sum of the inverse masses, for any
  /// number of sweeps; otherwise Bullet's default of 1.
  LinkEngine(const scene::Scene& scene, const std::vector<double>& state, const Plan& plan,
             bool matched)
      : ClassicEngine(scene, state, false) {
    const double h = plan.h;
    if (plan.sweeps > 0) body().m_cfg.piterations = plan.sweeps;
    for (std::size_t s = 0; matched && s < scene.springs.size(); ++s) {
      btSoftBody::Link& link = body().m_links[static_cast<int>(s)];
      const double w = link.m_n[0]->m_im + link.m_n[1]->m_im;
      const double strength = -std::expm1(-std::log1p(scene.springs[s].stiffness * w * h * h) /
                                          body().m_cfg.piterations);
      link.m_c0 = w / strength;  // as in btSoftBody::updateLinkConstants
    }
    const double rate = *medium_damping(scene) + anchored_damping(scene).value_or(0);
    body().m_cfg.kDP =
        rate * h / (1 + rate * h);  // the remaining factor 1/(1 + b h) is backward Euler's
  }
};

}  // namespace

std::unique_ptr<Engine> make_soft_body_force(const scene::Scene& scene,
                                             const std::vector<double>& state, const Plan&) {
  return std::make_unique<ForceEngine>(scene, state);
}

std::unique_ptr<Engine> make_soft_body_collision(const scene::Scene& scene,
                                                 const std::vector<double>& state, const Plan&) {
  return std::make_unique<CollisionEngine>(scene, state);
}

std::unique_ptr<Engine> make_soft_body_links(const scene::Scene& scene,
                                             const std::vector<double>& state, const Plan& plan) {
  return std::make_unique<LinkEngine>(scene, state, plan, true);
}

std::unique_ptr<Engine> make_soft_body_links_stock(const scene::Scene& scene,
                                                   const std::vector<double>& state,
                                                   const Plan& plan) {
  return std::make_unique<LinkEngine>(scene, state, plan, false);
}

}  // namespace odeum::adapters::bullet
