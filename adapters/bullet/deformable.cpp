// SPDX-License-Identifier: BSD-3-Clause
// Deformable bodies in btDeformableMultiBodyDynamicsWorld, explicit and implicit.
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>

#include <map>
#include <tuple>

#include "engine.hpp"
#include "exerted.hpp"
#include "expressible.hpp"
#include "soft_body.hpp"

namespace odeum::adapters::bullet {
namespace {

/// A viscous medium in the deformable world: a damper without stiffness from each free particle to
/// an added fixed particle at its initial position. The added particles come after the scene's.
struct WithDampers {
  scene::Scene scene;
  std::vector<double> state;
};

WithDampers with_dampers(const scene::Scene& scene, const std::vector<double>& state, double rate) {
  WithDampers result{scene, {}};
  const auto positions_end = state.begin() + static_cast<std::ptrdiff_t>(3 * scene.size());
  result.state.assign(state.begin(), positions_end);
  for (std::size_t i = 0; i < scene.size(); ++i) {
    if (scene.particles[i].fixed) continue;
    scene::Particle post = scene.particles[i];
    post.fixed = true;
    result.scene.springs.push_back(
        {.a = result.scene.size(), .b = i, .damping = rate * scene.particles[i].mass});
    result.scene.particles.push_back(post);
    for (std::size_t d = 0; d < 3; ++d) result.state.push_back(state[3 * i + d]);
  }
  result.state.insert(result.state.end(), positions_end, state.end());
  result.state.resize(6 * result.scene.size(), 0);
  return result;
}

/// Bullet's solver with settable iteration counts. Defaults: 300 iterations of conjugate gradients,
/// one Newton iteration.
class CountedSolver final : public btDeformableBodySolver {
 public:
  void count(const Plan& plan) {
    if (plan.sweeps > 0) m_cg.m_maxIterations = plan.sweeps;
    if (plan.newton == 0) return;
    m_maxNewtonIterations = plan.newton;
    m_newtonTolerance = 0;  // the default 1e-4 N s ends them early
  }
};

/// Exerts nothing, and counts the products of the forces' derivative with a vector: Bullet asks
/// each force once for its part of one.
class ProductCounter final : public btDeformableLagrangianForce {
 public:
  std::uint64_t count() const { return count_; }

  void addScaledForces(btScalar, TVStack&) override {}
  void addScaledExplicitForce(btScalar, TVStack&) override {}
  void addScaledDampingForce(btScalar, TVStack&) override {}
  void addScaledElasticForceDifferential(btScalar, const TVStack&, TVStack&) override {}
  void addScaledDampingForceDifferential(btScalar, const TVStack&, TVStack&) override { ++count_; }
  void buildDampingForceDifferentialDiagonal(btScalar, TVStack&) override {}
  btDeformableLagrangianForceType getForceType() override { return BT_LINEAR_ELASTICITY_FORCE; }

 private:
  std::uint64_t count_ = 0;
};

/// Forces on the nodes that are given for a step, in place of a law.
class GivenForces final : public btDeformableLagrangianForce {
 public:
  void set(int node, const btVector3& force) { forces_[node] = force; }
  void addSoftBody(btSoftBody* body) override {
    btDeformableLagrangianForce::addSoftBody(body);
    forces_.resize(body->m_nodes.size(), btVector3(0, 0, 0));
  }

  void addScaledForces(btScalar scale, TVStack& force) override {
    const auto& nodes = m_softBodies[0]->m_nodes;
    for (int i = 0; i < nodes.size(); ++i) force[nodes[i].index] += scale * forces_[i];
  }
  void addScaledExplicitForce(btScalar scale, TVStack& force) override {
    addScaledForces(scale, force);
  }
  void addScaledDampingForce(btScalar, TVStack&) override {}
  void addScaledElasticForceDifferential(btScalar, const TVStack&, TVStack&) override {}
  void addScaledDampingForceDifferential(btScalar, const TVStack&, TVStack&) override {}
  void buildDampingForceDifferentialDiagonal(btScalar, TVStack&) override {}
  // One that this world has no other force of, and Bullet's solver no rule for.
  btDeformableLagrangianForceType getForceType() override { return BT_LINEAR_ELASTICITY_FORCE; }

 private:
  TVStack forces_;
};

/// The links of equal stiffness and damping with their force, which acts on all links of a body: on
/// a body that is not in the world and has links alone, between the nodes of the one that is.
struct LinkGroup {
  LinkGroup(btSoftBodyWorldInfo& info, const scene::Spring& spring)
      : links(&info), force(spring.stiffness, spring.damping, spring.axial) {
    links.setActivationState(DISABLE_DEACTIVATION);
    force.addSoftBody(&links);
  }
  btSoftBody links;
  /// Its third argument: whether damping acts on the relative velocity along the spring only.
  btDeformableMassSpringForce force;
};

scene::Scene without_surfaces(scene::Scene scene) {
  scene.surfaces.clear();
  return scene;
}

enum class Mode { explicit_, implicit, self_collision };

class DeformableEngine final : public Engine {
 public:
  DeformableEngine(const scene::Scene& scene, const std::vector<double>& state, const Plan& plan,
                   Mode mode)
      : exerted_(mode == Mode::self_collision ? without_surfaces(scene) : scene, false),
        world_(&parts_.dispatcher, &parts_.broadphase, &contacts_, &parts_.configuration,
               &solver_) {
    if (mode == Mode::implicit) solver_.count(plan);
    contacts_.setDeformableSolver(&solver_);
    world_.setImplicit(mode == Mode::implicit);
    world_.setUseProjection(true);  // required by the implicit solver
    world_.getWorldInfo().m_maxDisplacement = no_displacement_limit;
    if (const double rate = *medium_damping(scene); rate != 0) {
      const WithDampers dampers = with_dampers(scene, state, rate);
      build(dampers.scene, dampers.state);
    } else {
      build(scene, state);
    }
    if (mode == Mode::self_collision) collide(scene);
  }

  void exert(double t, Guard& guard) override {
    if (!exerted_.any()) return;
    exerted_.visit(t, *body_, {}, guard, [&](std::size_t i, const scene::Vec3& f) {
      given_.set(static_cast<int>(i), btVector3(f[0], f[1], f[2]));
    });
  }
  bool step(double h) override { return world_.stepSimulation(h, 0) == 1; }
  std::uint64_t products() const override { return counter_.count(); }
  const btSoftBody& body() const override { return *body_; }

 private:
  /// As Bullet's example of a deformable body that collides with itself sets it.
  void collide(const scene::Scene& scene) {
    const scene::SelfContact& law = scene.surfaces.front();
    for (const scene::Surface& surface : scene.surfaces)
      for (const auto& [a, b, c] : surface.faces)
        body_->appendFace(static_cast<int>(a), static_cast<int>(b), static_cast<int>(c));
    body_->m_cfg.collisions = btSoftBody::fCollision::VF_DD;
    body_->setSelfCollision(true);
    body_->getCollisionShape()->setMargin(law.thickness / 2);  // those of both add
    body_->setSpringStiffness(law.stiffness);                  // of the repulsion within it
    body_->m_cfg.kDF = law.friction;
    body_->initializeFaceTree();
  }

  /// Not by addForce, which gives the body to the first force of a kind in place of the second.
  void add(btDeformableLagrangianForce& force) {
    force.setIndices(solver_.getIndices());
    solver_.getLagrangianForceArray()->push_back(&force);
  }

  void build(const scene::Scene& scene, const std::vector<double>& state) {
    btSoftBodyWorldInfo& info = world_.getWorldInfo();
    body_ = make_body(info, scene, state);
    world_.addSoftBody(body_.get());
    // Also for zero gravity: without this force the implicit solver reads an uninitialised one.
    gravity_.m_gravity.setValue(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
    world_.addForce(body_.get(), &gravity_);
    if (exerted_.any()) world_.addForce(body_.get(), &given_);
    add(counter_);
    std::map<std::tuple<double, double, bool>, LinkGroup*> kinds;
    for (std::size_t s = 0; s < scene.springs.size(); ++s) {
      const scene::Spring& spring = scene.springs[s];
      LinkGroup*& group = kinds[{spring.stiffness, spring.damping, spring.axial}];
      if (!group) {
        groups_.push_back(std::make_unique<LinkGroup>(info, spring));
        group = groups_.back().get();
        add(group->force);
      }
      group->links.m_links.push_back(body_->m_links[static_cast<int>(s)]);
    }
  }

  Exerted exerted_;
  CollisionParts parts_;
  CountedSolver solver_;
  btDeformableMultiBodyConstraintSolver contacts_;
  btDeformableGravityForce gravity_{btVector3(0, 0, 0)};
  GivenForces given_;
  ProductCounter counter_;
  std::vector<std::unique_ptr<LinkGroup>> groups_;  // made in the world, and outlive it
  std::unique_ptr<btSoftBody> body_;                // outlives the world, which lets go of it
  btDeformableMultiBodyDynamicsWorld world_;
};

}  // namespace

std::unique_ptr<Engine> make_deformable_explicit(const scene::Scene& scene,
                                                 const std::vector<double>& state,
                                                 const Plan& plan) {
  return std::make_unique<DeformableEngine>(scene, state, plan, Mode::explicit_);
}

std::unique_ptr<Engine> make_deformable_implicit(const scene::Scene& scene,
                                                 const std::vector<double>& state,
                                                 const Plan& plan) {
  return std::make_unique<DeformableEngine>(scene, state, plan, Mode::implicit);
}

std::unique_ptr<Engine> make_deformable_self_collision(const scene::Scene& scene,
                                                       const std::vector<double>& state,
                                                       const Plan& plan) {
  return std::make_unique<DeformableEngine>(scene, state, plan, Mode::self_collision);
}

}  // namespace odeum::adapters::bullet
