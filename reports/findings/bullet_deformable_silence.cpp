// SPDX-License-Identifier: BSD-3-Clause
// Findings on the deformable world. (a) A NaN in its linear solve is set to zero: with a damping of
// NaN a run goes on, finite, as if undamped. (b) The implicit solver, where its matrix is
// indefinite at once (across compressed springs), takes the impulse (kg m/s) for the change of
// velocity (m/s), so that a body of another mass accelerates just the same. (c) The explicit solver
// clamps speeds to the bounding box's diagonal a step: a lone node falls no faster than
// 0.866 m a step, and with a margin of 0 never moves.
// Bullet alone; exits 0 while all three stand. Built as bullet_link_law.cpp.
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>

struct Setting {
  bool implicit = false;
  double mass = 1, rest_length = 1, stiffness = 0, damping = 0, margin = 0.25;
  bool link = true;
  btVector3 velocity{0, 0, 0}, gravity{0, 0, 0};
};

/// The velocity after one step of h of a node in the origin, linked to fixed ones at (1, 0, 0) and
/// (-1, 0, 0).
btVector3 velocity_after_step(const Setting& s, double h) {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btDeformableBodySolver solver;
  btDeformableMultiBodyConstraintSolver contacts;
  contacts.setDeformableSolver(&solver);
  btDeformableMultiBodyDynamicsWorld world(&dispatcher, &broadphase, &contacts, &configuration,
                                           &solver);
  world.setImplicit(s.implicit);
  world.setUseProjection(true);
  const btVector3 positions[] = {{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}};
  const btScalar masses[] = {s.mass, 0, 0};
  btSoftBody body(&world.getWorldInfo(), s.link ? 3 : 1, positions, masses);
  body.m_cfg.collisions = 0;
  body.getCollisionShape()->setMargin(s.margin);
  for (int i = 1; s.link && i < 3; ++i) body.appendLink(0, i);
  body.updateConstants();
  body.m_bUpdateRtCst = false;
  for (int i = 0; i < body.m_links.size(); ++i) body.m_links[i].m_rl = s.rest_length;
  body.m_nodes[0].m_v = body.m_nodes[0].m_vn = s.velocity;
  world.addSoftBody(&body);
  btDeformableGravityForce gravity(s.gravity);
  btDeformableMassSpringForce spring(s.stiffness, s.damping, false);
  world.addForce(&body, &gravity);
  world.addForce(&body, &spring);
  world.stepSimulation(h, 0);
  world.removeSoftBody(&body);
  return body.m_nodes[0].m_v;
}

int main() {
  const double h = 0.1;

  Setting nan{.damping = std::nan(""), .velocity = {1, 0, 0}};
  const double undamped = velocity_after_step(nan, h).x();
  std::printf("(a) damping NaN: v = %g after a step from v = 1\n", undamped);

  // Across the links A = m + 2 h^2 k (1 - L/l) = m + 2 * 0.01 * 100 * (1 - 10) < 0, and no force
  // but gravity is left.
  double across[2];
  for (int i = 0; i < 2; ++i) {
    const double mass = i == 0 ? 2 : 4;
    across[i] = velocity_after_step({.implicit = true,
                                     .mass = mass,
                                     .rest_length = 10,
                                     .stiffness = 100,
                                     .gravity = {0, -1, 0}},
                                    h)
                    .y();
    std::printf("(b) mass %g: v across the springs = %g after a step of %g under gravity -1\n",
                mass, across[i], h);
  }

  const Setting falling{.link = false, .velocity = {0, -100, 0}};
  Setting marginless = falling;
  marginless.margin = 0;
  const double clamped = velocity_after_step(falling, h).length();
  const double stuck = velocity_after_step(marginless, h).length();
  std::printf("(c) a lone node at 100 m/s: %g m/s after a step with the margin 0.25, %g with 0\n",
              clamped, stuck);

  const auto is = [](double x, double value) { return std::abs(x - value) < 1e-12; };
  return is(undamped, 1) && is(across[0], -2 * h) && is(across[1], -4 * h) &&
                 is(clamped, std::sqrt(3.0) * 0.5 / h) && is(stuck, 0)
             ? 0
             : 1;
}
