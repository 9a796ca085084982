// SPDX-License-Identifier: BSD-3-Clause
// Soft bodies in btSoftRigidDynamicsWorld: with forces applied to their nodes, or with links.
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>

#include <array>
#include <cmath>

#include "engine.hpp"
#include "expressible.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "soft_body.hpp"

namespace odeum::adapters::bullet {
namespace {

class ClassicEngine : public Engine {
 public:
  ClassicEngine(const scene::Scene& scene, const std::vector<double>& state)
      : world_(&parts_.dispatcher, &parts_.broadphase, &solver_, &parts_.configuration) {
    btSoftBodyWorldInfo& info = world_.getWorldInfo();
    info.m_gravity.setValue(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
    info.m_maxDisplacement = no_displacement_limit;
    body_ = make_body(info, scene, state);
    world_.addSoftBody(body_.get());
  }

  bool step(double h) override { return world_.stepSimulation(h, 0) == 1; }
  const btSoftBody& body() const override { return *body_; }

 protected:
  btSoftBody& body() { return *body_; }

 private:
  CollisionParts parts_;
  btSequentialImpulseConstraintSolver solver_;
  std::unique_ptr<btSoftBody> body_;  // outlives the world, which only refers to it
  btSoftRigidDynamicsWorld world_;
};

/// The adapter applies the forces of springs and medium, the world gravity.
class ForceEngine final : public ClassicEngine {
 public:
  ForceEngine(const scene::Scene& scene, const std::vector<double>& state)
      : ClassicEngine(scene, state),
        springs_(springs_of(scene)),
        medium_(scene.velocity_matrix),
        n_(3 * scene.size()),
        q_(n_),
        v_(n_),
        a_(n_) {
    body().m_links.clear();
    body().m_cfg.piterations = 0;  // otherwise velocities are recomputed from positions
  }

  void exert(double t, Guard& guard) override {
    const auto& nodes = body().m_nodes;
    const auto node = [&](std::size_t i) -> const btSoftBody::Node& {
      return nodes[static_cast<int>(i)];
    };
    for (std::size_t i = 0; i < n_; ++i) {
      q_[i] = node(i / 3).m_x[static_cast<int>(i % 3)];
      v_[i] = node(i / 3).m_v[static_cast<int>(i % 3)];
    }
    springs_.acceleration(t, q_.data(), v_.data(), a_.data());
    for (std::size_t i = 0; i < n_; i += 3)
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
          a_[i + row] += medium_[3 * row + column] * v_[i + column];
    guard.inspect(t, a_.data(), n_);
    for (std::size_t i = 0; i < n_ / 3; ++i)
      if (node(i).m_im > 0)
        body().addForce(btVector3(a_[3 * i], a_[3 * i + 1], a_[3 * i + 2]) / node(i).m_im,
                        static_cast<int>(i));
  }

 private:
  static scene::Scene springs_of(scene::Scene scene) {
    scene.gravity = {};
    scene.velocity_matrix = {};
    return scene;
  }

  scene::SceneProblem springs_;
  std::array<double, 9> medium_;
  std::size_t n_;
  std::vector<double> q_, v_, a_;
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
      : ClassicEngine(scene, state) {
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
