// SPDX-License-Identifier: BSD-3-Clause
// Deformable bodies in btDeformableMultiBodyDynamicsWorld, explicit and implicit.
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>

#include <optional>

#include "engine.hpp"
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

class DeformableEngine final : public Engine {
 public:
  DeformableEngine(const scene::Scene& scene, const std::vector<double>& state, const Plan& plan,
                   bool implicit)
      : world_(&parts_.dispatcher, &parts_.broadphase, &contacts_, &parts_.configuration,
               &solver_) {
    if (implicit) solver_.count(plan);
    contacts_.setDeformableSolver(&solver_);
    world_.setImplicit(implicit);
    world_.setUseProjection(true);  // required by the implicit solver
    world_.getWorldInfo().m_maxDisplacement = no_displacement_limit;
    if (const double rate = *medium_damping(scene); rate != 0) {
      const WithDampers dampers = with_dampers(scene, state, rate);
      build(dampers.scene, dampers.state);
    } else {
      build(scene, state);
    }
  }

  bool step(double h) override { return world_.stepSimulation(h, 0) == 1; }
  const btSoftBody& body() const override { return *body_; }

 private:
  void build(const scene::Scene& scene, const std::vector<double>& state) {
    body_ = make_body(world_.getWorldInfo(), scene, state);
    world_.addSoftBody(body_.get());
    // Also for zero gravity: without this force the implicit solver reads an uninitialised one.
    gravity_.m_gravity.setValue(scene.gravity[0], scene.gravity[1], scene.gravity[2]);
    world_.addForce(body_.get(), &gravity_);
    if (!scene.springs.empty()) {
      // "false": damping acts on the whole relative velocity, as in the scene, not along the spring
      // only.
      springs_.emplace(scene.springs[0].stiffness, scene.springs[0].damping, false);
      world_.addForce(body_.get(), &*springs_);
    }
  }

  CollisionParts parts_;
  CountedSolver solver_;
  btDeformableMultiBodyConstraintSolver contacts_;
  btDeformableGravityForce gravity_{btVector3(0, 0, 0)};
  std::optional<btDeformableMassSpringForce> springs_;
  std::unique_ptr<btSoftBody> body_;  // outlives the world, which lets go of it
  btDeformableMultiBodyDynamicsWorld world_;
};

}  // namespace

std::unique_ptr<Engine> make_deformable_explicit(const scene::Scene& scene,
                                                 const std::vector<double>& state,
                                                 const Plan& plan) {
  return std::make_unique<DeformableEngine>(scene, state, plan, false);
}

std::unique_ptr<Engine> make_deformable_implicit(const scene::Scene& scene,
                                                 const std::vector<double>& state,
                                                 const Plan& plan) {
  return std::make_unique<DeformableEngine>(scene, state, plan, true);
}

}  // namespace odeum::adapters::bullet
