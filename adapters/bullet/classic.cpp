// SPDX-License-Identifier: BSD-3-Clause
// Soft bodies in btSoftRigidDynamicsWorld: with forces applied to their nodes, or with links.
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <cmath>

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
  void add_forces(double t, const scene::Mat3& matrix, Guard& guard) {
    exerted_.visit(t, *body_, matrix, guard, [&](std::size_t i, const scene::Vec3& f) {
      body_->addForce(btVector3(f[0], f[1], f[2]), static_cast<int>(i));
    });
  }

 private:
  Exerted exerted_;
  CollisionParts parts_;
  btSequentialImpulseConstraintSolver solver_;
  std::unique_ptr<btSoftBody> body_;  // outlives the world, which only refers to it
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
