// SPDX-License-Identifier: BSD-3-Clause
// Finding: the stiffness of a Bullet soft body's links at the default kLST = 1. Measured: (a) a
// hanging chain is four times as stiff at half the step, and twice as stiff with twice the sweeps;
// (b) a free net with one sweep gains kinetic energy at a small step. Bullet alone; exits 0 while
// that stands. g++ -std=c++20 -DBT_USE_DOUBLE_PRECISION -I/usr/include/bullet
// bullet_link_stiffness.cpp
//     -lBulletSoftBody-float64 -lBulletDynamics-float64 -lBulletCollision-float64
//     -lLinearMath-float64
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <cstdio>
#include <utility>
#include <vector>

struct World {
  btSoftBodyRigidBodyCollisionConfiguration configuration;
  btCollisionDispatcher dispatcher{&configuration};
  btDbvtBroadphase broadphase;
  btSequentialImpulseConstraintSolver solver;
  btSoftRigidDynamicsWorld world{&dispatcher, &broadphase, &solver, &configuration};

  explicit World(double gravity) { world.getWorldInfo().m_gravity.setValue(0, -gravity, 0); }
  void run(btSoftBody& body, double h, double seconds) {
    body.m_cfg.collisions = 0;
    body.setActivationState(DISABLE_DEACTIVATION);
    world.addSoftBody(&body);
    for (int k = 0; k * h < seconds; ++k) world.stepSimulation(h, 0);
    world.removeSoftBody(&body);
  }
};

/// How far the lowest of ten masses of 0.1 kg on links of 1 m sags, at 1 m/s^2, m.
double sag(double h, int sweeps) {
  World world(1);
  std::vector<btVector3> positions;
  std::vector<btScalar> masses;
  for (int i = 0; i <= 10; ++i) {
    positions.emplace_back(0, -i, 0);
    masses.push_back(i == 0 ? 0 : 0.1);
  }
  btSoftBody body(&world.world.getWorldInfo(), 11, positions.data(), masses.data());
  for (int i = 0; i < 10; ++i) body.appendLink(i, i + 1);
  body.m_cfg.piterations = sweeps;
  world.run(body, h, 20);
  return -10 - body.m_nodes[10].m_x.y();
}

/// Kinetic energy after 5 s over the initial one, of a free net of 11 x 11 on links to all
/// neighbours one and two away, its middle with an initial 7.5 m/s along each axis.
double energy_left(double h) {
  constexpr int n = 11;
  constexpr std::size_t nodes = std::size_t{n} * n;
  World world(0);
  std::vector<btVector3> positions;
  const std::vector<btScalar> masses(nodes, 3.0 / nodes);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) positions.emplace_back(i / 10.0, j / 10.0, 0);
  btSoftBody body(&world.world.getWorldInfo(), n * n, positions.data(), masses.data());
  const auto energy = [&] {
    double sum = 0;
    for (int i = 0; i < n * n; ++i) sum += body.m_nodes[i].m_v.length2();
    return sum;
  };
  for (int i = 3; i <= 8; ++i)
    for (int j = 3; j <= 8; ++j) body.m_nodes[i * n + j].m_v.setValue(7.5, 7.5, 7.5);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (const int reach : {1, 2})
        for (const auto& [di, dj] : {std::pair{0, 1}, {1, -1}, {1, 0}, {1, 1}}) {
          const int k = i + reach * di, l = j + reach * dj;
          if (k < n && l >= 0 && l < n) body.appendLink(i * n + j, k * n + l);
        }
  const double first = energy();
  world.run(body, h, 5);
  return energy() / first;
}

int main() {
  const double coarse = sag(1.0 / 120, 1), fine = sag(1.0 / 240, 1), swept = sag(1.0 / 120, 2);
  std::printf("(a) sag %.3e m at 1/120 s, %.3e m at 1/240 s, %.3e m with two sweeps\n", coarse,
              fine, swept);
  const double nominal = 55 * 0.1 / 1000;
  std::printf("    as stiff as %.2f, %.2f and %.2f times 1000 N/m\n", nominal / coarse,
              nominal / fine, nominal / swept);
  bool stands =
      coarse / fine > 3.9 && coarse / fine < 4.1 && coarse / swept > 1.9 && coarse / swept < 2.1;
  double last = 0;
  for (const int rate : {60, 240, 960, 1920}) {
    last = energy_left(1.0 / rate);
    std::printf("(b) kinetic energy left after 5 s at h = 1/%d s: %.3f\n", rate, last);
  }
  return stands && last > 1 ? 0 : 1;
}
