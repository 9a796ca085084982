// SPDX-License-Identifier: BSD-3-Clause
// Finding: the double-precision btSoftRigidDynamicsWorld hands its soft bodies the step rounded to
// float, so that a run ends at t (1 + d) with |d| up to 6e-8; btDeformableMultiBodyDynamicsWorld
// does not. Bullet alone; exits 0 while that stands. Built as bullet_link_law.cpp.
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>

/// How far a free node of velocity 1 m/s moves in 1000 steps of h.
template <class World>
double distance(World& world, double h) {
  const btVector3 start(0, 0, 0);
  const btScalar mass = 1;
  world.getWorldInfo().m_gravity.setZero();
  btSoftBody body(&world.getWorldInfo(), 1, &start, &mass);
  body.m_cfg.collisions = 0;
  body.setActivationState(DISABLE_DEACTIVATION);
  body.m_nodes[0].m_v = body.m_nodes[0].m_vn = btVector3(1, 0, 0);
  world.addSoftBody(&body);
  for (int i = 0; i < 1000; ++i) world.stepSimulation(h, 0);
  world.removeSoftBody(&body);
  return body.m_nodes[0].m_x.x();
}

int main() {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btSoftRigidDynamicsWorld classic(&dispatcher, &broadphase, &solver, &configuration);
  btDbvtBroadphase other_broadphase;
  btDeformableBodySolver deformable_solver;
  btDeformableMultiBodyConstraintSolver contacts;
  contacts.setDeformableSolver(&deformable_solver);
  btDeformableMultiBodyDynamicsWorld deformable(&dispatcher, &other_broadphase, &contacts,
                                                &configuration, &deformable_solver);
  deformable.setUseProjection(true);

  const double h = 0.001, end = 1;
  const double rounded = 1000 * static_cast<double>(static_cast<float>(h));
  const double a = distance(classic, h), b = distance(deformable, h);
  std::printf(
      "1000 steps of 0.001 s at 1 m/s: classic %.12f, deformable %.12f, float(h) says %.12f\n", a,
      b, rounded);
  const double rounding = 1e-12;  // a thousand sums of doubles
  return std::abs(a - rounded) < rounding && std::abs(a - end) > 1e-9 &&
                 std::abs(b - end) < rounding
             ? 0
             : 1;
}
