// SPDX-License-Identifier: BSD-3-Clause
#include "soft_body.hpp"

namespace odeum::adapters::bullet {

btDefaultCollisionConstructionInfo CollisionParts::small_pools() {
  btDefaultCollisionConstructionInfo info;
  info.m_defaultMaxPersistentManifoldPoolSize = 1;
  info.m_defaultMaxCollisionAlgorithmPoolSize = 1;
  return info;
}

std::unique_ptr<btSoftBody> make_body(btSoftBodyWorldInfo& world_info, const scene::Scene& scene,
                                      const std::vector<double>& state) {
  const std::size_t n = scene.size();
  const auto vector = [](const double* p) { return btVector3(p[0], p[1], p[2]); };
  std::vector<btVector3> positions;
  std::vector<btScalar> masses;
  for (std::size_t i = 0; i < n; ++i) {
    positions.push_back(vector(state.data() + 3 * i));
    masses.push_back(scene.particles[i].fixed ? 0 : scene.particles[i].mass);
  }
  auto body = std::make_unique<btSoftBody>(&world_info, static_cast<int>(n), positions.data(),
                                           masses.data());
  body->setActivationState(DISABLE_DEACTIVATION);
  body->m_cfg.collisions = 0;
  body->getCollisionShape()->setMargin(endless_margin);
  // The implicit deformable solver starts from m_vn, everything else from m_v.
  for (std::size_t i = 0; i < n; ++i)
    if (!scene.particles[i].fixed) {
      btSoftBody::Node& node = body->m_nodes[static_cast<int>(i)];
      node.m_v = node.m_vn = vector(state.data() + 3 * (n + i));
    }
  body->m_links.reserve(static_cast<int>(scene.springs.size()));
  for (const scene::Spring& spring : scene.springs)
    body->appendLink(static_cast<int>(spring.a), static_cast<int>(spring.b));
  // Otherwise Bullet takes the present lengths as rest lengths at the first step.
  body->updateConstants();
  body->m_bUpdateRtCst = false;
  for (std::size_t s = 0; s < scene.springs.size(); ++s) {
    btSoftBody::Link& link = body->m_links[static_cast<int>(s)];
    link.m_rl = scene.springs[s].rest_length;
    link.m_c1 = link.m_rl * link.m_rl;
  }
  return body;
}

}  // namespace odeum::adapters::bullet
