// SPDX-License-Identifier: BSD-3-Clause
// Finding: what force does a link of a Bullet soft body exert, where kLST is matched to a stiffness
// k so that one link does backward Euler at small strain? Measured: k l (l^2 - L^2)/(l^2 + L^2) as
// h -> 0, not k (l - L). Bullet alone; exits 0 while that stands.
// g++ -std=c++20 -DBT_USE_DOUBLE_PRECISION -I/usr/include/bullet bullet_link_law.cpp
//     -lBulletSoftBody-float64 -lBulletDynamics-float64 -lBulletCollision-float64
//     -lLinearMath-float64
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <cstdio>

/// The acceleration of a unit mass on a link of length l, over one step of h from rest.
double measured_acceleration(double l, double rest_length, double stiffness, double h) {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher(&configuration);
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  const btVector3 positions[] = {{0, 0, 0}, {l, 0, 0}};
  const btScalar masses[] = {0, 1};
  btSoftRigidDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
  world.getWorldInfo().m_gravity.setZero();
  btSoftBody body(&world.getWorldInfo(), 2, positions, masses);
  body.m_cfg.collisions = 0;
  body.m_materials[0]->m_kLST = 1 - 1 / (1 + stiffness * h * h);
  body.appendLink(0, 1);
  body.updateConstants();
  body.m_bUpdateRtCst = false;
  body.m_links[0].m_rl = rest_length;
  body.m_links[0].m_c1 = rest_length * rest_length;
  world.addSoftBody(&body);
  world.stepSimulation(h, 0);
  world.removeSoftBody(&body);
  return body.m_nodes[1].m_v.x() / h;
}

int main() {
  const double rest_length = 1, stiffness = 5, h = 1.0 / 4096;
  bool stands = true;
  std::printf("stretch   measured    -k l (l^2-L^2)/(l^2+L^2)   -k (l-L)\n");
  for (const double l : {0.5, 0.9, 0.99, 1.01, 1.1, 1.5, 2.0}) {
    const double measured = measured_acceleration(l, rest_length, stiffness, h);
    const double squares =
        -stiffness * l * (l * l - rest_length * rest_length) / (l * l + rest_length * rest_length);
    const double linear = -stiffness * (l - rest_length);
    std::printf("%6.2f %12.8f %18.8f %18.8f\n", l, measured, squares, linear);
    stands = stands && std::abs(measured - squares) < 1e-5 * std::abs(squares) &&
             std::abs(measured - linear) > 1e-5 * std::abs(linear);
  }
  return stands ? 0 : 1;
}
